"""The equations of the notes as they are printed there, read from their LaTeX."""

import pytest

from rigidtop.proof.equation import Equation
from rigidtop.read.equations import equations as read

LATEX = {
    "3.33": (r"0 = \dot{\mathbf{L}} = \frac{d}{dt}(I\boldsymbol{\omega})"),
    "3.34": (r"\mathbf{r}' = O^{T}\mathbf{r}"),
    "3.35": (
        r"0 = \left(\frac{\partial\mathbf{L}}{\partial t}\right)_{\text{space}} = "
        r"\left(\frac{\partial\mathbf{L}}{\partial t}\right)_{\text{body}} + "
        r"\boldsymbol{\omega} \times \mathbf{L}"
    ),
    "3.36": (r"\lambda_{1}\dot{\omega}_{1} = (\lambda_{2} - \lambda_{3})\omega_{2}\omega_{3}"),
    "3.37": (
        r"\dot{\omega}_{1} = \underbrace{\frac{(\lambda_{1} - "
        r"\lambda_{3})\omega_{3}}{\lambda_{1}}}_{\equiv \Omega_{b}}\omega_{2} = "
        r"\Omega_{b}\omega_{2}"
    ),
    "3.37b": (
        r"\dot{\omega}_{2} = -\frac{(\lambda_{1} - "
        r"\lambda_{3})\omega_{3}}{\lambda_{1}}\omega_{1} = -\Omega_{b}\omega_{1}"
    ),
    "3.38": (
        r"\boldsymbol{\omega} = [\omega_{0}\cos(\Omega_{b}t), -\omega_{0}\sin(\Omega_{b}t), "
        r"\omega_{3}]^{T}"
    ),
    "3.42": (
        r"\boldsymbol{\omega} = \underbrace{(-\dot{\phi}\sin\theta)}_{\equiv "
        r"\omega_{1'}}\mathbf{e}_{1}' + \dot{\theta}\mathbf{e}_{2}' + (\dot{\psi} + "
        r"\dot{\phi}\cos\theta)\mathbf{e}_{3}"
    ),
    "3.44": (
        r"T = \tfrac{1}{2}\boldsymbol{\omega} \cdot \mathbf{L} = "
        r"\tfrac{1}{2}\lambda_{1}(\dot{\phi}^{2}\sin^{2}\theta + \dot{\theta}^{2}) + "
        r"\tfrac{1}{2}\lambda_{3}(\dot{\psi} + \dot{\phi}\cos\theta)^{2}"
    ),
    "3.45": (r"\dot{\phi} = \frac{L_{z} - L_{3}\cos\theta}{\lambda_{1}\sin^{2}\theta}"),
    "3.47": (
        r"O^{T} = \begin{bmatrix} c_{\phi}c_{\theta}c_{\psi} - s_{\phi}s_{\psi} & "
        r"-c_{\psi}s_{\phi} - c_{\phi}c_{\theta}s_{\psi} & c_{\phi}s_{\theta} \\ "
        r"c_{\phi}s_{\psi} + c_{\theta}c_{\psi}s_{\phi} & c_{\phi}c_{\psi} - "
        r"c_{\theta}s_{\phi}s_{\psi} & s_{\phi}s_{\theta} \\ -c_{\psi}s_{\theta} & "
        r"s_{\theta}s_{\psi} & c_{\theta} \end{bmatrix}"
    ),
    "3.48": (
        r"\mathbf{N}_{\text{ext}} = \sum_{k} \mathbf{r}_{k} \times \mathbf{F}_{k} = \int "
        r"d^{3}\mathbf{r}\,\mathbf{r} \times \mathbf{f}"
    ),
    "3.49": (
        r"\mathbf{N}_{\text{ext}} = -g\int d^{3}\mathbf{r}\,\rho\mathbf{r} \times "
        r"\hat{\mathbf{z}} = -g\left(\int d^{3}\mathbf{r}\,\rho\mathbf{r}\right) \times "
        r"\hat{\mathbf{z}} = -gM\frac{\left(\int d^{3}\mathbf{r}\,\rho\mathbf{r}\right)}{M} "
        r"\times \hat{\mathbf{z}} = -gM\mathbf{R}_{\text{CM}} \times \hat{\mathbf{z}} = "
        r"\mathbf{R}_{\text{CM}} \times \underbrace{\mathbf{F}_{\text{grav}}}_{\equiv "
        r"-gM\hat{\mathbf{z}}}"
    ),
    "3.51": (
        r"\dot{\mathbf{e}}_{3} = \frac{MgR}{\lambda_{3}\omega_{3}}\hat{\mathbf{z}} \times "
        r"\mathbf{e}_{3} = \boldsymbol{\Omega} \times \mathbf{e}_{3}"
    ),
    "3.53": (
        r"\mathcal{L} = \tfrac{1}{2}\lambda_{1}(\dot{\phi}^{2}\sin^{2}\theta + "
        r"\dot{\theta}^{2}) + \tfrac{1}{2}\lambda_{3}(\dot{\psi} + "
        r"\dot{\phi}\cos\theta)^{2} - MgR\cos\theta"
    ),
    "3.54": (
        r"\lambda_{1}\ddot{\theta} = \lambda_{1}\dot{\phi}^{2}\sin\theta\cos\theta - "
        r"\lambda_{3}(\dot{\psi} + \dot{\phi}\cos\theta)\dot{\phi}\sin\theta + MgR\sin\theta"
    ),
    "3.55": (
        r"p_{\phi} = \lambda_{1}\dot{\phi}\sin^{2}\theta + \lambda_{3}(\dot{\psi} + "
        r"\dot{\phi}\cos\theta)\cos\theta = \text{const}"
    ),
    "3.57a": (
        r"0 = \lambda_{1}\dot{\phi}^{2}\sin\theta\cos\theta - \lambda_{3}(\dot{\psi} + "
        r"\dot{\phi}\cos\theta)\dot{\phi}\sin\theta + MgR\sin\theta"
    ),
    "3.57b": (
        r"0 = \lambda_{1}\Omega^{2}\cos\theta - \lambda_{3}\underbrace{(\dot{\psi} + "
        r"\dot{\phi}\cos\theta)}_{\equiv \omega_{3}}\Omega + MgR"
    ),
    "3.57": (r"0 = (\lambda_{1}\cos\theta)\Omega^{2} - (\lambda_{3}\omega_{3})\Omega + MgR"),
}


@pytest.fixture(scope="session")
def printed() -> dict[str, Equation]:
    """By number; "3.57a" and "3.57b" are the lines above (3.57)."""
    lines = {number: read(formula) for number, formula in LATEX.items()}
    return {n: Equation(*line.equation.sides, tag=n) for n, [line] in lines.items()}
