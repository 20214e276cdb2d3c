/**
 * three.js r130, whose build is a classic script with a global THREE.  The package that ships it
 * has no types: what stands here says which of its classes is meant, and checks nothing of them.
 */
declare const THREE: any;
declare namespace THREE {
  type BufferAttribute = any;
  type Camera = any;
  type Color = any;
  type Group = any;
  type Material = any;
  type MaterialOptions = Record<string, unknown>;
  type Mesh = any;
  type Object3D = any;
  type Quaternion = any;
  type ShaderMaterial = any;
  type Vector3 = any;
}
