"""Kinds of lines that students write, each marked as a lecturer would."""

import pytest

from rigidtop.mark.answer import mark
from rigidtop.mark.task import task

RIGHT = {
    "tensor times column": (
        "3.42 3.43",
        r"$$\vec L=\begin{pmatrix}\lambda_1&0&0\\0&\lambda_1&0\\0&0&\lambda_3\end{pmatrix}"
        r"\begin{pmatrix}-\dot\phi\sin\theta\\\dot\theta\\\dot\psi+\dot\phi\cos\theta\end{pmatrix}"
        r"=\begin{pmatrix}-\lambda_1\dot\phi\sin\theta\\\lambda_1\dot\theta\\"
        r"\lambda_3(\dot\psi+\dot\phi\cos\theta)\end{pmatrix}$$",
    ),
    "unit vectors in a determinant, a dot seen from the body": (
        "3.35 3.36",
        r"In the body frame $\dot{\mathbf L}+\boldsymbol\omega\times\mathbf L=0$ with "
        r"$$\boldsymbol\omega\times\mathbf L=\begin{vmatrix}\mathbf e_1&\mathbf e_2&\mathbf e_3\\"
        r"\omega_1&\omega_2&\omega_3\\"
        r"\lambda_1\omega_1&\lambda_2\omega_2&\lambda_3\omega_3\end{vmatrix}$$"
        r"$$\lambda_1\dot\omega_1=(\lambda_2-\lambda_3)\omega_2\omega_3,\quad"
        r"\lambda_2\dot\omega_2=(\lambda_3-\lambda_1)\omega_3\omega_1,\quad"
        r"\lambda_3\dot\omega_3=(\lambda_1-\lambda_2)\omega_1\omega_2$$",
    ),
    "a name behind a constant": (
        "3.53 3.56",
        r"$$\lambda_3(\dot\psi+\dot\phi\cos\theta)=\text{const}\equiv p_\psi$$",
    ),
    "another principal axis": (
        "3.36 principal-stays",
        r"Set $\omega_3=0$ and $\omega_1=0$. Then $\dot{\boldsymbol\omega}=0$.",
    ),
    "small rates beside another axis": (
        "3.36 axis-stability",
        r"$\omega_2,\omega_3\ll\omega_1$, so $\omega_1\approx$ const and "
        r"$$\ddot\omega_2\approx-\frac{(\lambda_1-\lambda_3)(\lambda_1-\lambda_2)}"
        r"{\lambda_2\lambda_3}\omega_1^2\omega_2$$",
    ),
    "the exact frequency, at an angle with an index": (
        "3.54 nutation",
        r"$$\omega_n^2=\frac{(\lambda_3\omega_3-2\lambda_1\Omega\cos\theta_s)^2}{\lambda_1^2}"
        r"+\Omega^2\sin^2\theta_s$$",
    ),
    "other letters, which are said to be equal": (
        "3.43 3.45",
        r"$$\dot\phi=\frac{p_\phi-p_\psi\cos\theta}{\lambda_1\sin^2\theta}$$ "
        r"where $p_\phi=L_z$ and $p_\psi=L_3$.",
    ),
    "a supposition in words, and what it means": (
        "3.36 principal-stays",
        r"Suppose $\boldsymbol\omega$ is along $\mathbf e_1$, so $\omega_2=\omega_3=0$. Then "
        r"$\dot\omega_1=\dot\omega_2=\dot\omega_3=0$.",
    ),
    "a vector of the answer's own, which moves": (
        "3.50 3.51",
        r"The torque is $\mathbf R\times M\mathbf g=MgR\,\hat{\mathbf z}\times\mathbf e_3$, so "
        r"$$\dot{\mathbf e}_3=\frac{MgR}{\lambda_3\omega_3}\hat{\mathbf z}\times\mathbf e_3"
        r"=\boldsymbol\Omega\times\mathbf e_3$$",
    ),
    "numbered roots": (
        "3.57 two-roots",
        r"$$\Omega_{1,2}=\frac{\lambda_3\omega_3\pm\sqrt{\lambda_3^2\omega_3^2"
        r"-4\lambda_1MgR\cos\theta}}{2\lambda_1\cos\theta}$$ For large $\omega_3$: "
        r"$$\Omega_2\approx\frac{MgR}{\lambda_3\omega_3}$$",
    ),
    "what is small where something else is large": (
        "3.57 two-roots",
        r"For large $\omega_3$ use $\sqrt{1-x}\approx1-\frac x2$, "
        r"$x=\frac{4\lambda_1MgR\cos\theta}{\lambda_3^2\omega_3^2}$, in the root. Hence "
        r"$$\Omega_-\approx\frac{MgR}{\lambda_3\omega_3},\qquad"
        r"\Omega_+\approx\frac{\lambda_3\omega_3}{\lambda_1\cos\theta}$$",
    ),
    "the tensor of inertia by its letter, blank off the diagonal": (
        "3.38 3.39",
        r"$\vec L=\mathbf I\,\vec\omega$ with $$\mathbf I=\begin{pmatrix}\lambda_1&&\\&\lambda_1&\\"
        r"&&\lambda_3\end{pmatrix},\quad \vec L=\begin{pmatrix}\lambda_1\omega_0\cos\Omega_bt\\"
        r"-\lambda_1\omega_0\sin\Omega_bt\\\lambda_3\omega_3\end{pmatrix}$$",
    ),
    "a chain that goes on behind a remark in brackets": (
        "3.37 omega-oscillator",
        r"$\frac{d}{dt}$ of the first one gives $\ddot\omega_1=\Omega_b\dot\omega_2$ "
        r"(as $\dot\Omega_b=0$) $=-\Omega_b^2\omega_1$, likewise $\ddot"
        r"\omega_2=-\Omega_b^2\omega_2$.",
    ),
    "hence, by an arrow": (
        "3.41 3.42",
        r"$\hat z=\cos\theta\,\vec e_3-\sin\theta\,\vec e_1{}'$ $\rightarrow\vec\omega=-\dot\phi"
        r"\sin\theta\,\vec e_1{}'+\dot\theta\,\vec e_2{}'+(\dot\phi\cos\theta+\dot\psi)\vec e_3$",
    ),
    "an index that is a sign, below a fraction": (
        "3.36 3.37",
        r"$\lambda_1=\lambda_2=I_\perp$, $\lambda_3=I_\parallel$, "
        r"$\Omega_b=\frac{I_\perp-I_\parallel}{I_\perp}\omega_3$ and "
        r"$\dot\omega_1=\Omega_b\omega_2$, $\dot\omega_2=-\Omega_b\omega_1$.",
    ),
    "a period that the pages have for one sign": (
        "3.36 3.40",
        r"$\Omega_b=\frac{\lambda_1-\lambda_3}{\lambda_1}\omega_3$, $\tau_b=2\pi/\Omega_b$.",
    ),
    "L and U for the Lagrangian and the potential": (
        "3.44 3.53",
        r"$$L=T-U=\tfrac12\lambda_1(\dot\theta^2+\dot\phi^2\sin^2\theta)"
        r"+\tfrac12\lambda_3(\dot\psi+\dot\phi\cos\theta)^2-MgR\cos\theta$$",
    ),
    "an effective potential of the answer's own, named after its use": (
        "3.53 3.57",
        r"$$E=\frac12\lambda_1\dot\theta^2+U(\theta),\quad U(\theta)=\frac{(p_\phi-p_\psi\cos"
        r"\theta)^2}{2\lambda_1\sin^2\theta}+MgR\cos\theta+\frac{p_\psi^2}{2\lambda_3}$$ Steady: "
        r"$0=\frac{dU}{d\theta}$, so $$\lambda_1\cos\theta\,\Omega^2-\lambda_3"
        r"\omega_3\Omega+MgR=0$$",
    ),
    "a limit of what is said to be much smaller": (
        "3.57 slow-agrees",
        r"$\Omega_-=2MgR/\left(\lambda_3\omega_3+\sqrt{\lambda_3^2\omega_3^2-4"
        r"\lambda_1MgR\cos\theta}"
        r"\right)$."
        r" Fast top: $4\lambda_1MgR\cos\theta\ll\lambda_3^2\omega_3^2$, and "
        r"$$\Omega_-\to\frac{MgR}{\lambda_3\omega_3}$$",
    ),
    "axes by their exchange, and a subscript z": (
        "3.50 3.51",
        r"$$\dot{\vec e}_3=\frac{MgR}{\lambda_3\omega_3}\,\hat e_z\times\vec e_3$$",
    ),
    "code for a formula in plain text": (
        "3.42 3.43",
        "As `L_k = lambda_k omega_k`, $\\vec L=-\\lambda_1\\dot\\phi\\sin\\theta\\,\\vec e_1'"
        "+\\lambda_1\\dot\\theta\\,\\vec e_2'+\\lambda_3(\\dot\\psi+\\dot"
        "\\phi\\cos\\theta)\\vec e_3$.",
    ),
    "a motion that is tried, with its time": (
        "3.37 3.38",
        r"Try $\omega_1(t)=A\cos(\Omega_bt)+B\sin(\Omega_bt)$. Then "
        r"$\omega_2=\frac1{\Omega_b}\dot\omega_1=-A\sin(\Omega_bt)+B\cos(\Omega_bt)$. With "
        r"$\omega_2(0)=0$: $B=0$ and $A=\omega_0$, so $\omega_1=\omega_0\cos(\Omega_bt)$, "
        r"$\omega_2=-\omega_0\sin(\Omega_bt)$, $\omega_3=$ const.",
    ),
    "a case of its own, and otherwise": (
        "3.54 3.57",
        r"Steady: $0=\lambda_1\Omega^2sc-\lambda_3\omega_3\Omega s+MgRs$ with $s=\sin\theta$, "
        r"$c=\cos\theta$. The case $s=0$ is the sleeping top. Otherwise "
        r"$$\lambda_1c\,\Omega^2-\lambda_3\omega_3\Omega+MgR=0$$",
    ),
    "a remark on the pole, where the equations of motion have none": (
        "3.53 3.55",
        r"For $\theta=0$ this is $p_\phi=\lambda_3(\dot\psi+\dot\phi)$, the spin alone. In general "
        r"$$p_\phi=\lambda_1\dot\phi\sin^2\theta+\lambda_3(\dot\psi+\dot\phi\cos\theta)\cos\theta"
        r"=\text{const}$$",
    ),
    "components for a vector, the prime in the index": (
        "3.41 3.42",
        r"$$\omega_{1'}=-\dot\phi\sin\theta,\quad\omega_{2'}=\dot\theta,\quad"
        r"\omega_3=\dot\psi+\dot\phi\cos\theta$$",
    ),
    "axes that are not bold": (
        "3.41 3.42",
        r"$$\vec\omega=-\dot\phi\sin\theta\,e_1'+\dot\theta\,e_{2'}"
        r"+(\dot\psi+\dot\phi\cos\theta)e_3$$",
    ),
    "one name for two moments": (
        "3.41 3.44",
        r"Write $A$ for $\lambda_1=\lambda_2$ and $C$ for $\lambda_3$. Then $T=\frac12A\dot\phi^2"
        r"\sin^2\theta+\frac12A\dot\theta^2+\frac12C(\dot\psi+\dot\phi\cos\theta)^2$.",
    ),
    "what is struck out": (
        "3.53 3.54",
        "~~$\\lambda_1\\ddot\\theta=MgR\\cos\\theta$~~ and \\sout{$0=MgR$}\n"
        r"$$\lambda_1\ddot\theta=\lambda_1\dot\phi^2\sin\theta\cos\theta-\lambda_3"
        r"(\dot\psi+\dot\phi\cos\theta)\dot\phi\sin\theta+MgR\sin\theta$$",
    ),
    "a transformation, and how a derivative is written": (
        "3.53 3.56",
        r"$\psi\to\psi+\epsilon$ changes nothing. With $\partial_\psi\mathcal L=\frac{\partial"
        r"\mathcal L}{\partial\psi}$: $\lambda_3(\dot\psi+\dot\phi\cos\theta)=$ const.",
    ),
    "the rate of a length": (
        "3.43 torque-perpendicular",
        r"With $\dot\theta=0$ $$\frac{d}{dt}|\mathbf L|=\frac{\mathbf L\cdot\mathbf N}"
        r"{|\mathbf L|}=0$$",
    ),
    "differentials": (
        "3.50 3.52",
        r"The horizontal part $\lambda_3\omega_3\sin\theta$ turns by "
        r"$$d\phi=\frac{MgR\sin\theta\,dt}{\lambda_3\omega_3\sin\theta}$$ "
        r"$$\mathbf\Omega=\frac{MgR}{\lambda_3\omega_3}\,\hat{\mathbf z}$$",
    ),
    "a start where nothing changes": (
        "3.36 principal-stays",
        r"At $t=0$ let $\omega_3=w$, $\omega_1=0$, $\omega_2=0$. Then "
        r"$\lambda_1\dot\omega_1=(\lambda_2-\lambda_3)\cdot0\cdot w=0$, "
        r"so $\boldsymbol\omega(t)=w\mathbf e_3$ for all times and $\dot{\boldsymbol\omega}=0$.",
    ),
    "a start that is said twice": (
        "3.36 principal-stays",
        r"Let $\boldsymbol\omega(0)=w\mathbf e_2$, i.e. $\omega_1=\omega_3=0$, $\omega_2=w$. "
        r"It stays: $\dot{\boldsymbol\omega}=0$.",
    ),
    "a frame by what it turns with": (
        "3.53 3.54",
        r"With $\mathbf w=\dot\phi\hat{\mathbf z}+\dot\theta\mathbf e_2'$ and "
        r"$\mathbf N=MgR\sin\theta\,\mathbf e_2'$: "
        r"$\left(\dot{\mathbf L}\right)_{\text{frame}}+\mathbf w\times\mathbf L=\mathbf N$, so "
        r"$\lambda_1\ddot\theta=\lambda_1\dot\phi^2\sin\theta\cos\theta-\lambda_3"
        r"(\dot\psi+\dot\phi\cos\theta)\dot\phi\sin\theta+MgR\sin\theta$.",
    ),
    "an example in numbers": (
        "3.57 two-roots",
        r"$$\Omega_\pm=\frac{\lambda_3\omega_3\pm\sqrt{\lambda_3^2\omega_3^2-4\lambda_1MgR"
        r"\cos\theta}}{2\lambda_1\cos\theta}$$ For large $\omega_3$: "
        r"$\Omega_-\approx\frac{MgR}{\lambda_3\omega_3}$, "
        r"$\Omega_+\approx\frac{\lambda_3\omega_3}{\lambda_1\cos\theta}$. "
        r"Example: $\lambda_1=2$, $\lambda_3=1$, $MgR=3$, $\omega_3=20$, $\theta=60^\circ$. "
        r"Then $\Omega=10\pm\sqrt{97}$.",
    ),
    "a component along a primed axis": (
        "3.53 3.54",
        r"It turns with $\mathbf w=-\dot\phi\sin\theta\,\mathbf e_1'+\dot\theta\,\mathbf e_2'"
        r"+\dot\phi\cos\theta\,\mathbf e_3$. $$(\mathbf w\times\mathbf L)_{2'}=w_3L_{1'}-w_{1'}L_3"
        r"=-\lambda_1\dot\phi^2\sin\theta\cos\theta+\lambda_3\omega_3\dot\phi\sin\theta$$"
        r"$$\lambda_1\ddot\theta-\lambda_1\dot\phi^2\sin\theta\cos\theta+\lambda_3\omega_3\dot\phi"
        r"\sin\theta=MgR\sin\theta$$ with $\omega_3=\dot\psi+\dot\phi\cos\theta$.",
    ),
    "the bracket with a Hamiltonian": (
        "3.53 3.56",
        r"$$H=\frac{p_\theta^2}{2\lambda_1}+\frac{(p_\phi-p_\psi\cos\theta)^2}{2\lambda_1\sin^2"
        r"\theta}+\frac{p_\psi^2}{2\lambda_3}+MgR\cos\theta$$ $$\dot p_\psi=\{p_\psi,H\}=0$$ and "
        r"$p_\psi=\lambda_3(\dot\psi+\dot\phi\cos\theta)=\text{const}$.",
    ),
    "a test without a tilt, and a prime that is none of the index": (
        "3.42 3.44",
        r"$\omega_1'=-\dot\phi\sin\theta$. $$T=\tfrac12\lambda_1(\dot\phi^2\sin^2\theta"
        r"+\dot\theta^2)+\tfrac12\lambda_3(\dot\psi+\dot\phi\cos\theta)^2$$ Test: $\theta=0$ and "
        r"$\dot\theta=0$ gives $T=\tfrac12\lambda_3(\dot\psi+\dot\phi)^2$.",
    ),
    "vectors in plain text": (
        "3.42 3.44",
        "T = ½ ω·L with L = (λ₁ω₁', λ₁ω₂', λ₃ω₃)\n\n$T = ½λ₁(φ̇² sin²θ + θ̇²) + ½λ₃(ψ̇ + φ̇ cosθ)²$",
    ),
    "a start in components of the body": (
        "3.36 principal-stays",
        r"Start with $\boldsymbol\omega(0)=(w,0,0)$. I claim $\boldsymbol\omega(t)=(w,0,0)$. "
        r"Check: $\lambda_1\dot\omega_1=(\lambda_2-\lambda_3)\cdot0\cdot0=0$. "
        r"So $\dot{\boldsymbol\omega}=0$.",
    ),
    "the axis along the angular momentum": (
        "3.33 space-cone",
        r"I may put the $z$ axis along it: $L_z=L$. Then $\lambda_3\omega_3=L\cos\theta$, "
        r"$-\lambda_1\dot\phi\sin\theta=-L\sin\theta$ and $\Omega_s=\dot\phi=\frac L{\lambda_1}$.",
    ),
    "polar coordinates of the answer's own": (
        "3.37 3.38",
        r"$\omega_1=\rho\cos\chi$, $\omega_2=\rho\sin\chi$: $$\rho^2\dot\chi=\omega_1\dot\omega_2-"
        r"\omega_2\dot\omega_1=-\Omega_b\rho^2,\quad\rho\dot\rho=\omega_1\dot\omega_1+\omega_2"
        r"\dot\omega_2=0$$ So $\rho=\omega_0$, $\chi=-\Omega_bt$ and "
        r"$$\omega_1=\omega_0\cos(\Omega_bt),\quad\omega_2=-\omega_0\sin(\Omega_bt),\quad\omega_3=\text{const}$$",
    ),
    "an operator in front of a fraction, and a sign at the end": (
        "3.53 3.56",
        r"$$\frac{\partial}{\partial\dot\psi}\,\frac{\lambda_3}{2}\left(\dot\psi+\dot\phi\cos\theta"
        r"\right)^2=\lambda_3(\dot\psi+\dot\phi\cos\theta)=\text{const}$$ $\square$ "
        r"$p_\psi=\lambda_3(\dot\psi+\dot\phi\cos\theta)=\text{const}$",
    ),
    "terms that are left out": (
        "3.53 3.55",
        r"$$\mathcal L=\frac12(\lambda_1\sin^2\theta+\lambda_3\cos^2\theta)\dot\phi^2+\dots$$ so "
        r"$p_\phi=\lambda_1\dot\phi\sin^2\theta+\lambda_3(\dot\psi+\dot\phi\cos\theta)\cos\theta"
        r"=\text{const}$",
    ),
    "a product of vectors that are not bold": (
        "3.43 3.45",
        r"$s\equiv\sin\theta$, $c\equiv\cos\theta$. $L_z=L\cdot\hat z=-s\,L_{1'}+c\,L_3$ gives "
        r"$$\dot\phi=\frac{L_z-L_3\,c}{\lambda_1\,s^2}$$",
    ),
}


@pytest.mark.parametrize(("ends", "source"), RIGHT.values(), ids=RIGHT)
def test_a_right_answer_passes(ends, source):
    assert mark(source, task(*ends.split())).passed


def test_a_component_is_what_its_vector_is_along_that_axis():
    source = "$L_{{1'}}=-\\lambda_1\\dot\\phi\\sin\\theta$\n\n$L_{{2'}}={}\\dot\\theta$"
    ends = task("3.42", "3.43")
    assert mark(source.format(r"\lambda_1"), ends).first_wrong is None
    assert mark(source.format(r"\lambda_3"), ends).first_wrong.line == 3


ASCII = """
    L_z = L_3*cos(theta) + lambda_1*phidot*sin(theta)^2

Solve for phidot (not at the poles, where sin(theta) = 0):

    phidot = (L_z - L_3*cos(theta)) / (lambda_1*sin(theta)^2)
"""


@pytest.mark.parametrize(
    ("ends", "source"),
    [
        ("3.43 3.45", ASCII),
        # a letter for one of the notes, and places behind what was to be shown
        ("3.53 3.55", r"I write $A$ for $\lambda_1$ and $C$ for $\lambda_3$."
         r"$$p_\phi=(A\sin^2\theta+C\cos^2\theta)\dot\phi+C\dot\psi\cos\theta=\text{const.}$$"
         r" At $\theta=\pi/2$ one gets $p_\phi=A\dot\phi$, at $\theta=0$ one gets"
         r" $p_\phi=C(\dot\phi+\dot\psi)$."),
        # an effective potential in letters that stay what they are
        ("3.53 3.54", r"$$U(\theta)=\frac{(L_z-L_3\cos\theta)^2}{2\lambda_1\sin^2\theta}"
         r"+MgR\cos\theta$$ $$\lambda_1\ddot\theta=-U'(\theta)$$ With"
         r" $L_z-L_3\cos\theta=\lambda_1\dot\phi\sin^2\theta$ $$\lambda_1\ddot\theta="
         r"\lambda_1\dot\phi^2\sin\theta\cos\theta-\lambda_3(\dot\psi+\dot\phi\cos\theta)"
         r"\dot\phi\sin\theta+MgR\sin\theta$$"),
        # parts of a sum are named one after the other
        ("3.42 3.44", r"$$T=T_1+T_2$$ $$T_1=\tfrac12\lambda_1(\dot\phi^2\sin^2\theta"
         r"+\dot\theta^2)$$ $$T_2=\tfrac12\lambda_3(\dot\psi+\dot\phi\cos\theta)^2$$"
         r"$$T=\tfrac12\lambda_1(\dot\phi^2\sin^2\theta+\dot\theta^2)"
         r"+\tfrac12\lambda_3(\dot\psi+\dot\phi\cos\theta)^2$$"),
    ],
)  # fmt: skip
def test_what_students_write_passes(ends, source):
    marking = mark(source, task(*ends.split()))
    assert marking.first_wrong is None
    assert marking.passed


def test_a_part_of_a_sum_that_does_not_fit_is_wrong():
    source = r"""$$T=T_1+T_2$$
$$T_1=\tfrac12\lambda_1(\dot\phi^2\sin^2\theta+\dot\theta^2)$$
$$T_2=\lambda_3(\dot\psi+\dot\phi\cos\theta)^2$$"""
    assert mark(source, task("3.42", "3.44")).first_wrong.line == 3


def test_values_at_the_start_may_stand_in_a_chain():
    source = "$\\omega_1(0)=\\omega_3(0)=0$, $\\omega_2(0)=w$."
    assert mark(source, task("3.36", "principal-stays")).first_wrong is None


def test_a_value_may_stand_before_its_condition():
    source = "$$\\dot\\phi=\\frac{L_z-L_3\\cos\\theta}{\\lambda_1\\sin^2\\theta}$$\n"
    source += "$\\dot\\phi=0$ for $\\cos\\theta=L_z/L_3$."
    assert mark(source, task("3.45", "azimuth")).first_wrong is None


@pytest.mark.parametrize(
    ("under", "right"), [("\\cos\\theta", True), ("2\\cos\\theta", False), ("\\sin\\theta", False)]
)
def test_what_is_nearly_true_for_something_large_is_refuted_too(under, right):
    source = "For large $\\omega_3$\n$$\\Omega_+\\approx\\frac{\\lambda_3\\omega_3}"
    source += f"{{\\lambda_1{under}}}$$"
    assert (mark(source, task("3.57", "two-roots")).first_wrong is None) == right


@pytest.mark.parametrize(("sign", "right"), [("-", True), ("", False)])
def test_what_is_much_smaller_is_small_together(sign, right):
    source = "$\\omega_1,\\omega_2\\ll\\omega_3$, so $\\omega_3\\approx$ const.\n$$\\ddot\\omega_1"
    source += f"\\approx{sign}\\frac{{(\\lambda_2-\\lambda_3)(\\lambda_1-\\lambda_3)}}"
    source += "{\\lambda_1\\lambda_2}\\omega_3^2\\omega_1$$"
    found = mark(source, task("3.36", "axis-stability"))
    assert (found.first_wrong is None) == right
    assert found.lines[-2].mark == "follows"


@pytest.mark.parametrize(
    ("ends", "source", "slip"),
    [
        (
            "3.53 3.55",
            r"$$p_\phi=\lambda_1\dot\phi\sin\theta+\lambda_3(\dot\psi+\dot"
            r"\phi\cos\theta)\cos\theta$$",
            "sin² θ in place of sin θ",
        ),
        (
            "3.53 3.54",
            r"$$\frac{\partial L}{\partial\dot\theta}=2\lambda_1\dot\theta$$",
            "no factor 2",
        ),
    ],
)
def test_a_slip_is_named_by_what_was_written(ends, source, slip):
    assert mark(source, task(*ends.split())).first_wrong.slip == slip


@pytest.mark.parametrize("between", ["and therefore", "holds.\n\nTherefore"])
def test_what_is_large_is_so_in_the_displays_behind_it(between):
    source = "For large $\\omega_3$\n$$\\sqrt{\\lambda_3^2\\omega_3^2-4\\lambda_1MgR\\cos\\theta}"
    source += f"\\approx\\lambda_3\\omega_3$$\n{between}\n$$\\Omega_+\\approx"
    right, wrong = (
        rf"\frac{{{x}}}$$"
        for x in (r"\lambda_3\omega_3}{\lambda_1\cos\theta", "MgR}{\\lambda_3\\omega_3")
    )
    ends = task("3.57", "two-roots")
    assert mark(source + right, ends).first_wrong is None
    assert mark(source + wrong, ends).first_wrong.said.startswith("Ω₊")


def test_another_axis_is_none_where_the_facts_tell_them_apart():
    source = r"$$\dot\omega_2=\frac{\lambda_2-\lambda_3}{\lambda_2}\omega_1\omega_3$$"
    assert not mark(source, task("3.36", "3.37")).passed


def test_what_is_concluded_in_a_display_is_not_supposed():
    source = "Suppose it is free, so\n$$\\omega_1=0$$"
    assert mark(source, task("3.36", "principal-stays")).first_wrong.line == 2


def test_what_holds_at_the_moment_that_was_named_is_not_called_wrong_and_shows_nothing():
    source = "Let $\\omega_2=0$ at $t=0$. Then\n"
    source += r"$$(\lambda_2-\lambda_3)\omega_2\omega_3={}$$"
    ends = task("3.36", "principal-stays")
    right = mark(source.replace("{}", "0"), ends)
    assert (right.first_wrong, right.passed) == (None, False)
    assert "the moment of which the line before speaks" in right.lines[-1].note
    assert mark(source.replace("{}", r"\lambda_3"), ends).first_wrong.line == 2


@pytest.mark.parametrize(
    ("ends", "source", "line"),
    [
        # only what is said of the case is meant for it
        ("3.53 3.55", "For $\\theta=0$ it is $p_\\phi=\\lambda_3(\\dot\\psi-\\dot\\phi)$.", 1),
        ("3.53 3.55", "For $\\theta=0$.\n\n$p_\\phi=\\lambda_3(\\dot\\psi+\\dot\\phi)$.", 3),
        # a frame turns with what stands beside it, in its order and with its sign
        (
            "3.53 3.54",
            "With $\\mathbf w=\\dot\\phi\\hat{\\mathbf z}+\\dot\\theta\\mathbf e_2'$ and "
            "$\\mathbf N=MgR\\sin\\theta\\mathbf e_2'$\n"
            "$$\\left(\\dot{\\mathbf L}\\right)_{\\text{frame}}"
            "+\\mathbf L\\times\\mathbf w=\\mathbf N$$",
            2,
        ),
        ("3.41 3.42", "$\\hat z=\\cos\\theta\\,e_3+\\sin\\theta\\,e_1'$", 1),
        ("3.33 space-cone", "Put $z$ along it: $L_z=L$.\n$\\lambda_3\\omega_3=L\\sin\\theta$", 2),
        ("3.42 3.44", "T = ½ ω·L + 1\n\nso", 1),
        ("3.50 3.52", "$$d\\phi=\\frac{2MgR\\,dt}{\\lambda_3\\omega_3}$$", 1),
        ("3.41 3.42", "$$\\omega_{1'}=\\dot\\phi\\sin\\theta,\\quad\\omega_{2'}=\\dot\\theta$$", 1),
    ],
)
def test_a_wrong_line_of_the_same_kinds_is_wrong(ends, source, line):
    marking = mark(source, task(*ends.split()))
    assert marking.first_wrong.line == line
    assert not marking.passed


def test_one_component_that_vanishes_at_the_start_does_not_stay_so():
    source = "At $t=0$ let $\\omega_1=0$.\n\nSo $\\omega_1(t)=0$ always."
    marking = mark(source, task("3.36", "principal-stays"))
    assert [x.mark.value for x in marking.lines] == ["assumption", "inconclusive"]


def test_a_name_behind_a_rate_is_known_in_front_of_it():
    source = r"$\omega_1,\omega_2\ll\omega_3$: "
    source += r"$$\dot\omega_2=\beta\,\omega_1,\quad"
    source += r"\beta=\frac{\lambda_3-\lambda_1}{\lambda_2}\omega_3$$"
    assert mark(source, task("3.36", "axis-stability")).first_wrong is None
    wrong = source.replace(r"\lambda_3-\lambda_1", r"\lambda_1-\lambda_3")
    assert mark(wrong, task("3.36", "axis-stability")).first_wrong.line == 1


def test_nothing_rests_on_the_numbers_of_an_example():
    source = r"Example: $\dot\phi=0$ and $\lambda_1=2$. All is well." + "\n\n"
    wrong = source + r"$$\lambda_1\ddot\theta=MgR\sin\theta$$"
    assert mark(wrong, task("3.53", "3.54")).first_wrong.line == 3
    assert mark(source + r"$\lambda_1=2$", task("3.53", "3.54")).first_wrong.line == 3


def test_what_a_case_gives_does_not_reach_a_goal():
    source = r"When $\dot\theta=0$, $\ddot\theta=1$ there. For $\theta=0$: $\lambda_1=0$."
    assert not mark(source, task("3.53", "3.54")).passed
