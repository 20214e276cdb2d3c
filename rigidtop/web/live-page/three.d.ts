/**
 * The part of three.js r130 that the scene uses; its build is a classic script with a global THREE.
 * Written by hand: the package that ships the build has no types.
 */
declare namespace THREE {
  const FrontSide: number;
  const DoubleSide: number;
  const DynamicDrawUsage: number;
  const GreaterDepth: number;

  class Vector2 {
    constructor(x?: number, y?: number);
    x: number;
    y: number;
  }

  class Vector3 {
    constructor(x?: number, y?: number, z?: number);
    x: number;
    y: number;
    z: number;
    set(x: number, y: number, z: number): this;
    copy(v: Vector3): this;
    multiplyScalar(s: number): this;
    applyQuaternion(q: Quaternion): this;
    normalize(): this;
    length(): number;
    project(camera: Camera): this;
  }

  class Quaternion {
    constructor(x?: number, y?: number, z?: number, w?: number);
    set(x: number, y: number, z: number, w: number): this;
    copy(q: Quaternion): this;
    invert(): this;
    setFromUnitVectors(from: Vector3, to: Vector3): this;
    setFromRotationMatrix(m: Matrix4): this;
  }

  class Matrix4 {
    makeBasis(x: Vector3, y: Vector3, z: Vector3): this;
  }

  class Color {
    constructor(colour?: string | number);
    readonly r: number;
    readonly g: number;
    readonly b: number;
    set(colour: string | Color): this;
    lerp(colour: Color, part: number): this;
  }

  class Object3D {
    readonly position: Vector3;
    readonly quaternion: Quaternion;
    readonly scale: Vector3;
    readonly up: Vector3;
    visible: boolean;
    frustumCulled: boolean;
    renderOrder: number;
    add(...objects: Object3D[]): this;
    lookAt(v: Vector3): void;
  }

  class Group extends Object3D {}

  class Scene extends Object3D {
    background: Color | null;
  }

  class AmbientLight extends Object3D {
    constructor(colour: number, intensity: number);
  }
  class DirectionalLight extends Object3D {
    constructor(colour: number, intensity: number);
  }

  class Camera extends Object3D {}

  class PerspectiveCamera extends Camera {
    constructor(fov: number, aspect: number, near: number, far: number);
    fov: number;
    aspect: number;
    setViewOffset(
      fullWidth: number, fullHeight: number, x: number, y: number, width: number, height: number,
    ): void;
  }

  class BufferAttribute {
    constructor(array: Float32Array | Uint16Array, itemSize: number);
    array: Float32Array;
    readonly count: number;
    needsUpdate: boolean;
    readonly updateRange: { offset: number; count: number };
    setUsage(usage: number): this;
  }

  class BufferGeometry {
    readonly attributes: { [name: string]: BufferAttribute };
    setIndex(index: BufferAttribute): this;
    setAttribute(name: string, attribute: BufferAttribute): this;
    setDrawRange(start: number, count: number): void;
    computeVertexNormals(): void;
    translate(x: number, y: number, z: number): this;
    rotateX(angle: number): this;
  }
  class BoxGeometry extends BufferGeometry {
    constructor(width: number, height: number, depth: number);
  }
  class CircleGeometry extends BufferGeometry {
    constructor(radius: number, segments: number);
  }
  class ConeGeometry extends BufferGeometry {
    constructor(radius: number, height: number, segments: number);
  }
  class CylinderGeometry extends BufferGeometry {
    constructor(
      top: number, bottom: number, height: number, segments: number, rings?: number, open?: boolean,
    );
  }
  class SphereGeometry extends BufferGeometry {
    constructor(radius: number, segments: number, rings: number);
  }
  class IcosahedronGeometry extends BufferGeometry {
    constructor(radius: number, detail: number);
  }

  class CanvasTexture {
    constructor(canvas: HTMLCanvasElement);
    needsUpdate: boolean;
  }

  interface MaterialOptions {
    color?: string | number;
    map?: CanvasTexture;
    specular?: string | number;
    shininess?: number;
    transparent?: boolean;
    opacity?: number;
    depthTest?: boolean;
    depthFunc?: number;
    depthWrite?: boolean;
    side?: number;
    vertexColors?: boolean;
    polygonOffset?: boolean;
    polygonOffsetFactor?: number;
    polygonOffsetUnits?: number;
  }

  class Material {
    readonly color: Color;
    visible: boolean;
    opacity: number;
  }
  class MeshPhongMaterial extends Material {
    constructor(options: MaterialOptions);
  }
  class MeshBasicMaterial extends Material {
    constructor(options: MaterialOptions);
  }
  class MeshLambertMaterial extends Material {
    constructor(options: MaterialOptions);
  }
  class ShaderMaterial extends Material {
    constructor(options: {
      uniforms: { [name: string]: { value: unknown } };
      vertexShader: string;
      fragmentShader: string;
      transparent?: boolean;
      depthWrite?: boolean;
      side?: number;
    });
  }

  class Mesh extends Object3D {
    constructor(geometry: BufferGeometry, material: Material);
    readonly geometry: BufferGeometry;
    readonly material: Material;
  }

  interface RendererOptions {
    canvas: HTMLCanvasElement;
    context: WebGLRenderingContext | WebGL2RenderingContext;
  }

  class WebGLRenderer {
    constructor(options: RendererOptions);
    setPixelRatio(ratio: number): void;
    setSize(width: number, height: number, style?: boolean): void;
    render(scene: Scene, camera: Camera): void;
  }

  class OrbitControls {
    constructor(camera: Camera, element: HTMLElement);
    readonly target: Vector3;
    minDistance: number;
    maxDistance: number;
    enablePan: boolean;
    rotateSpeed: number;
    update(): boolean;
    addEventListener(type: "change", listener: () => void): void;
  }
}
