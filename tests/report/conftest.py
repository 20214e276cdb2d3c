from ..typeset.conftest import printed

__all__ = ["printed"]
