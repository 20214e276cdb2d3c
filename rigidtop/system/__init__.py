"""Any mechanical system: from its Lagrangian to its equations, its derivation and its motions."""
