"""Anyone's letters and ways of writing: what is read is what is written, or it is not read."""

import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from rigidtop.notation import OWN
from rigidtop.read.formula import read
from rigidtop.read.habits import Habits
from rigidtop.read.look import components
from rigidtop.read.macros import PACKAGES, defined
from rigidtop.theory.symbols import Glyph
from rigidtop.typeset.latex import latex
from rigidtop.typeset.mathml import mathml
from rigidtop.typeset.text import text


def shown(source, habits=Habits(PACKAGES)):  # noqa: B008
    """What is read, as text; a reason in brackets."""
    return [
        text(line.equation, "typed") if line.equation else f"[{line.problem}]"
        for line in read(source, OWN, habits)
    ]


READ = {
    r"I = 4.0\text{ kg·m}^2": ["I = 4 kg·m^2"],
    r"T = 3\text{ s}^2": ["T = 3\u2009s²"],
    r"y = sinh(x) + arcsin x": ["y = sinh x + arcsin x"],
    r"\int_0^1 \sin[m](x)\,dx = a_{n-2}": ["∫[0, 1] sin^m x dx = a_{n−2}"],
    r"\omega = 1.5\text{ rev/s}": ["ω = (3/2) rev/s"],
    r"r_0 = 2\:\text{fm}": ["r₀ = 2 fm"],
    r"x\_1 = \Gamma\_{max}": ["x₁ = Γ_max"],
    r"F = m\ddot x": ["F = mẍ"],
    r"\tau^{(1)} = I_\mathrm{cm}\,\alpha": ["τ_(1) = I_cm α"],
    r"\bar x' = \tilde y'' + \mathcal H": ["x̄′ = ỹ′′ + ℋ"],
    # functions of letters
    r"V(x) = f(q, \dot q, t)": ["V(x) = f(q, q̇, t)"],
    r"x(t) = x(0) + v(t - t_0)": ["x(t) = x(0) + v(t − t₀)"],
    r"S[q] = \int_{t_1}^{t_2} L(q, \dot q)\,dt": ["S(q) = ∫[t₁, t₂] L(q, q̇) dt"],
    r"{R}(\theta) = R_1{(\phi)}": ["R(θ) = R₁(φ)"],
    r"y(x + a) = y(x)": ["y(x + a) = y(x)"],
    # derivatives
    r"\frac{d}{dt}\left(\frac{\partial L}{\partial\dot q}\right) = \frac{\partial L}{\partial q}": [
        "d/dt ∂L/∂q̇ = ∂L/∂q"
    ],
    r"\frac{\partial^2 f}{\partial x\partial y} = \frac{d^2 u}{d\phi^2}": [
        "∂/∂x (∂f/∂y) = d/dφ (du/dφ)"
    ],
    r"\frac{\mathrm d p}{\mathrm d t} = \partial_x U": ["ṗ = ∂U/∂x"],
    r"dL/dt = N": ["L̇ = N"],
    r"\dv{p}{t} = \pdv{L}{q}": ["ṗ = ∂L/∂q"],
    r"\mathrm dW = \vec F\cdot\mathrm d\vec r": ["dW = F · dr"],
    r"\left(\frac{d\vec A}{dt}\right)_{\rm rot} = 0": ["(∂A/∂t)_rot = 0"],
    r"\frac{d}{dt}\sum_i m_i v_i = 0": ["d/dt (Σ_i mᵢvᵢ) = 0"],
    # sums, integrals, places
    r"\sum_{i=1}^N m_i x_i = M X": ["Σ[i = 1, N] mᵢxᵢ = MX"],
    r"I = \int_V \rho r^2\,dV": ["I = ∫[V] ρr² dV"],
    r"t = \int \frac{dx}{\sqrt{x}}": ["t = ∫ dx/√x"],
    r"\left.\frac{dV}{dx}\right|_{x = a} = 0": ["(dV/dx)|_x = a = 0"],
    # signs, cases, lists
    r"x = \pm a \mp b": ["x = a − b", "x = −a + b"],
    r"x_{1,2} = -b\pm c": ["x₁ = −b + c", "x₂ = −b − c"],
    r"f = \begin{cases} a & x < 0 \\ b & x > 0 \end{cases}": ["f = a", "f = b"],
    r"\begin{cases} \dot x = y \\ \dot y = -x \end{cases}": ["ẋ = y", "ẏ = −x"],
    r"\left\{\begin{array}{l} a = b \\ c = h \end{array}\right.": ["a = b", "c = h"],
    r"q_i = 0, \quad i = 1, 2, \ldots, n": ["qᵢ = 0"],
    r"a \leq b \ll c": ["a ≤ b", "b ≪ c"],
    r"L := T - V \propto m": ["L ≡ T − V", "T − V ∝ m"],
    r"F = \left\{\begin{array}{rl} 0, & t < 0 \\ a, & t > 0 \end{array}\right.": ["F = 0", "F = a"],
    # functions, spelled and bare
    r"V = mglsin\theta": ["V = mgl sin θ"],
    r"x = A\cos\omega t": ["x = A cos(ωt)"],
    r"x = 2\sin\theta\dot\theta": ["x = 2 sin θ θ̇"],
    r"K = \begin{pmatrix} a & b \\[1.5ex] -k & c \end{pmatrix}": ["K = [a, b; −k, c]"],
    r"\epsilon_{\pm} = \pm a \mp b_\mp": ["ε₊ = a − b₋", "ε₋ = −a + b₊"],
    r"\hspace*{40pt} K = r_{\max}\hspace{1em}": ["K = r_max"],
    r"T = a^2(\dot x\,b) + c(x\,y)": ["T = a²(ẋb) + c(xy)"],
    r"{\vec F\cdot\vec v} = \underline{\underline{a + b}}": ["F · v = a + b"],
    r"I_{\small\text{Drift}} = GM_\odot": ["I_Drift = G M_⊙"],
    r"W = -\Delta PE": ["W = −ΔPE"],
    r"L = \textrm{a constant}": ["L = const"],
    r"t = \text{常数}": ["t = const"],
    r"y = \sqrt[3]{x}": ["y = ∛x"],
    r"y = a\cosh[x/a]": ["y = a cosh(x/a)"],
    r"F[x] = a,\quad h = F[x + b]": ["F(x) = a", "h = F(x + b)"],
    # vectors and matrices
    r"\vec L = \vec r\times m\vec v": ["L = r × mv"],
    r"T = \frac12\boldsymbol\omega^T\mathbf I\boldsymbol\omega": ["T = ½ωᵀIω"],
    r"\vec r = (x, y, z)": ["r = [x, y, z]"],
    r"Y = \begin{bmatrix} x \\ v \end{bmatrix}": ["Y = [x, v]ᵀ"],
    r"\vec F = \vec F_1 + \cdots + \vec F_n = \mathbf 0": ["F = F₁ + … + F_n = 0"],
    # what is only dress
    r"\boxed{E = {\color{red} m} c^2}": ["E = mc²"],
    r"E = {{a + b}\over c} \cr \underline{E = 0}": ["E = (a + b)/c", "E = 0"],
    r"m = 5\,\text{kg},\quad v = 3\times 10^2\ \mathrm{m/s}": ["m = 5 kg", "v = 3·10² m/s"],
    r"\text{Work} = E_\text{kin} - \frac{\text{loss}}{2}": ["Work = E_kin − loss/2"],
    r"L = \tfrac12 m \frac14 l^2": ["L = ½m·¼l²"],
    "T = ½ m ẋ², ω ≥ 0": ["T = ½mẋ²", "ω ≥ 0"],
}  # fmt: skip


@pytest.mark.parametrize("source", READ)
def test_what_is_written_is_read(source):
    assert shown(source) == READ[source]
    for line in read(source, OWN, Habits(PACKAGES)):
        assert line.equation is not None
        latex(line.equation, "typed")
        mathml(line.equation, "typed")


ASKED = {
    r"\alpha = +ve": "a function, or a product",
    r"\Omega = 2\omega(|\mathbf{k}|/2)": "or times it",
    r"m D^2x = 0": "an operator, or a factor",
    r"v = [v_1\:v_2\:v_3]^T": "a row without commas",
    r"a = [a_1\:\:a_2\:\:a_3]": "a row without commas",
    r"a = b \text{ where } c = d \\ &= e": "with which equation in front",
    r"H = \frac{d^n}{dy^n} e^{-y^2}": "an order that is no number",
    r"\frac{d^2x}{dt} = 0": "orders above and below differ",
    r"\frac{dx}{dt^2} = 0": "orders above and below differ",
    r"\frac{d^2}{dt^3}x = 0": "orders above and below differ",
    r"\frac{\partial^2 f}{\partial x\partial y\partial z} = 0": "orders above and below differ",
    r"d^2x/dt^2 = 0": "a derivative of higher order on one line",
    r"J = q\delta^4(X - R)": "with a power, and then what it is of",
    r"L = F_{\mu\nu}F^{\mu\nu}": "an index, or a power",
    r"\Sigma F = ma": "a factor, or a sum",
    r"det(K - M) = 0": "a function, or a product",
    r"y = ln(x)": "a function, or a product",
    r"\delta^2 S = 0": "with a power, and then what it is of",
    r"a = i [H, \psi]": "brackets with a comma",
    r"a = p_1(\cos\theta, \sin\theta, 0)": "or a row",
    r"a = p_1(1, 0, 0)": "or a row",
    r"\Omega = 2\omega_B(k/2)": "or times it",
    r"E = m\gamma(v/c)": "or times it",
    r"a = max(x, y)": "a function, or a product",
    r"\lambda g (y')^2 = 1": "or times its power",
    r"y = \cos kx": "of how much the function is",
    r"y = \sin\alpha t": "of how much the function is",
    r"W = m d \cos\theta + d x": "differential or a letter",
    r"p = d(mv)": "a differential, or a factor",
    r"x = f(a + b)": "or times it",
    r"\frac{dx}{dt}(t_0) = 0": "at a place, or times",
    r"a = q^i": "an index, or a power",
    r"I = I^C + m": "an index, or a power",
    r"P^0 = m": "an index, or a power",
    r"y = f^2(x)": "what it is a function of",
    r"F \text{ on a car} = m a": "words in the middle",
    r"a = b \text{ by symmetry} + c": "words in the middle",
    r"y = a\,\mathrm{cn}(\tau)": "the function cn is not known",
    r"F = \underbrace{-m a}_{a}\,\underbrace{-m g}_{b}": "a term, or a factor",
    r"(1)~ x = 0": "of the equation, or a factor",
    r"z = Force\,a": "a word or a product",
    r"Epc = qV": "a word or a product",
    r"f = \lambda(y), g = \lambda(y - x^2 + 1)": "or times it",
    r"\frac{\tilde{\mathrm{d}}}{\mathrm{d} t} r = 0": "a mark of its own",
    r"\dot x = [x, H]": "a commutator",
    r"\{x, p\} = 1": "a Poisson bracket",
    r"x = Re(z)": "real or imaginary part",
    r"y = D x": "an operator, or a factor",
    r"L = \vec r\times\vec p": "compared",
    r"\vec a\vec b = c": "· or ×",
    r"a \times b = c": "× between",
    r"W = \int F": "an integral without its dx",
    r"x = \foo y": r"the command \foo is not known",
    r"\alpha = 30^\circ": "degrees",
    r"x \in \mathbb R": "set",
    r"\langle x\rangle = 0": "average",
    r"a = 1/2 b": "above or below",
    r"x(t + T) = x(t)": "at the time in brackets, or times it",
    r"力 = m a": "words inside a formula",
    r"[h_0] = [r] = L": "its unit, or a factor",
    r"z = \Delta_{a}x": "the change of a letter",
    r"\psi =& \\ \frac{1}{a} & \int x\,dx": "a term could go on",
    r"F[x] = a, G = F[ay]": "or times it",
    r"v \approx 7{,}909": "a full stop, or thousands",
    r"p = L_{,\dot q}": "a derivative",
    r"\theta = 0,\pi": "a list of values",
    r"q = \{\phi, \theta\}": "a Poisson bracket",
    r"v = 90 m/s": "put a unit in",
    r"v = 2\,m/s": "put a unit in",
    r"T = 300\,K, m = 2.5\ kg": "put a unit in",
    r"h = 6.6 \times 10^{-34} \ m^{2} kg s^{-1}": "put a unit in",
    r"a &= 5.0 ms^{-2} \\ b &= 1": "put a unit in",
    r"a = b, and c": "a word or a product",
    r"m = y\,\text{Re}\,\Phi": "real or imaginary part",
    r"D\left\{(a\right.\\ \left.+b)c\right\}=d": "on one side alone",
    r"E = U\tan^2\alpha x_2": "of how much the function is",
    r"C = \epsilon^{\dot\alpha\dot\beta}": "an index, or a power",
    r"a = g_{\alpha\beta}X^{\alpha}": "an index, or a power",
    r"a = g^{-1}f(z)": "or operators",
    r"\varepsilon = \text{(antisymmetric)}": "ends too early",
    r"g = h^{-1}(hk)": "or operators",
    r"U = A^{(k - 1)}": "an index, or a power",
    r"T = m(0)^2": "or times its power",
    r"RAR^{-1} = h": "or operators",
    r"h = 6.626... \times 10^3": "digits are left out",
    r"\lambda^4 = \begin{pmatrix} 0 & 1 \\ 1 & 0 \end{pmatrix}": "an index, or a power",
    r"\beta = 0.2 \pm 2.5": "of a measured number",
    r"a = (\vec u, \vec v)": "a row, or their product",
    r"ZMP_x = a": "a word or a product",
    r"Re = \rho v": "a name",
    r"v = (\nabla\omega)(\mathbf{k})": "or times it",
    r"\dot q^n = \frac{\partial H}{\partial p_n}": "an index, or a power",
    r"d(x - x_0) = e \\\\ dx + ey = C": "a differential or a letter",
    r"F = 20kg-3kg": "its unit, or factors",
    r"(a, c) = 1": "a row and a number are compared",
    r"x = \mbox{0.33}": "the formula ends too early",
    # what mutations of real files found
    r"\sum_{ij}__{ij} q = 0": "a sum whose index is no letter",
    r"\sum_\vec _iy_i = x\cdot y": "a sum whose index is no letter",
    r"x = \underbrace{}{M}_y": "a brace without what stands at it",
    r"\int_{[3]^}^\infty dx = 0": "^ without what it is to act on",
}


@pytest.mark.parametrize("source", ASKED)
def test_what_could_mean_two_things_is_asked_for(source):
    assert any(ASKED[source] in line for line in shown(source)), shown(source)


def test_words_behind_a_line_are_its_condition():
    [line] = read(r"\ddot\theta = -\omega^2\theta \quad\text{for } \theta \ll 1", OWN)
    assert (text(line.equation), line.condition) == ("θ̈ = −ω²θ", "for θ ≪ 1")
    first, second = read(r"f = \begin{cases} a & x < 0 \\ b & \text{else} \end{cases}", OWN)
    assert (first.condition, second.condition) == ("x < 0", "else")
    assert shown(r"a = b \text{ and } c = h \text{ where } k = 1") == ["a = b", "c = h", "k = 1"]
    [line] = read(r"x_i = 0 \quad (i = 1, \dots, n)", OWN)
    assert (text(line.equation), line.condition) == ("xᵢ = 0", "(i = 1, …, n)")


def test_a_letter_is_a_function_where_the_file_says_so():
    assert shown("y = g(a + b)") == ["y = g(a + b)"]
    [product] = read("y = g(a + b)", OWN)
    habits = Habits(functions=frozenset({(Glyph("g"), "a")}))
    [called] = read("y = g(a + b)", OWN, habits)
    assert product.equation != called.equation
    habits = Habits(functions=frozenset({(Glyph("g"), "x")}))
    assert "or times it" in shown("y = g(a + b)", habits)[0]


def test_what_is_not_read_takes_what_stands_at_it_along():
    assert shown(r"\lim_{x\to a} y = b") == ["[a limit: that is not read]"]
    assert shown(r"\foo{S}{0,0} = 0") == [r"[the command \foo is not known of TeX]"]
    assert shown(r"W = \{v: T(v) = 0, \forall T\}, x = a")[1:] == ["x = a"]
    place = r"\left. \bar{\foo} \right|_{Q = R, P = S}, a = b"
    assert shown(place) == [r"[the command \foo is not known of TeX]", "a = b"]


def test_components_above_letters_are_no_powers():
    habits = Habits(components=frozenset(components("u = u^1") | components(r"p^\mu")))
    assert "a component, or a power" in shown("v = u^2", habits)[0]
    assert "a component, or a power" in shown("p^3 = 0", habits)[0]
    assert shown("E = p^2 + u_1^2", habits) == ["E = p² + u₁²"]
    assert "an index, or a power" in shown(r"x = q^\rho")[0]


def test_operators_and_distances_are_no_factors():
    for source in (r"L(t)\psi(x) = h\psi(x)", r"Lu = -\mu u", r"-Hy_1 = \lambda_1 w y_1"):
        assert shown(source) == ["[an operator before what it acts on, or a factor?]"]
    assert "an operator, or a factor" in shown(r"\mathcal{L} G = a")[0]
    assert "of a distance say, or a product" in shown("AB = c")[0]
    assert "a sum" in shown(r"\Sigma\ensuremath{F} = 0")[0]
    assert shown(r"y = \sum_n a_nx^n") == ["y = Σ_n a_n x^n"]
    kept = ["Mg = 2mg", "m = 2s", "T = 3N/k", "PV = nRT", "R = AB", "x = ABc"]
    assert [shown(source) for source in kept] == [[source] for source in kept]


def test_pi_is_a_letter_where_a_file_has_it_as_one():
    assert "the number, or the letter" in shown(r"x = \pi", Habits(letters=frozenset("π")))[0]
    assert shown(r"v = 331 + 2 T_C \text{ m/s}") == ["v = 331 + 2T_C m/s"]


MACROS = r"""
\newcommand{\half}{\tfrac12}  % a comment with \newcommand{\half}{\tfrac13}
\newcommand*\pd[2]{\frac{\partial #1}{\partial #2}}
\renewcommand{\vec}[1]{\mathbf{#1}}
\newcommand{\rate}[2][t]{\frac{d #2}{d #1}}
\def\w#1{\omega_{#1}}
\let\eps\varepsilon
\DeclareMathOperator{\sn}{sn}
"""


def test_an_authors_macros_are_put_in():
    habits = Habits(defined(MACROS))
    said = r"T = \half I\w3^2 + \pd Lq, \quad \vec F = \rate{\vec p}, \quad \rate[s]x = \eps"
    assert shown(said, habits) == ["T = ½Iω₃² + ∂L/∂q", "F = ṗ", "dx/ds = ε"]


@pytest.mark.parametrize(
    "definition",
    [
        r"\def\x{\x}",
        r"\def\x{\y}\def\y{\x}",
        r"\def\x{\x\x}",
        r"\def\a#1{#1#1}\def\b#1{\a{\a{\a{\a{#1}}}}}\def\c#1{\b{\b{\b{\b{#1}}}}}\def\x{\c{\c{a}}}",
        r"\newcommand{\x}[1]{#1#1#1#1}",
    ],
)
def test_macros_end(definition):
    habits = Habits(defined(definition))
    [reason] = shown(r"E = \x" + r"{\x" * 12 + "{a}" + "}" * 12, habits)
    assert "macro" in reason or "longer" in reason or "more than" in reason


PIECES = re.findall(
    r"\\(?:begin|end)\{\w+\}|\\right\|_\{x=0\}|\{[dt]\}|\(t\)|\\left\.|\\[a-z]+|\\.|\S| ",
    r"""\frac\left\right()[]\{\}{}|\|_^',.;&\\=+-/\pm\cdot\times d\partial\mathrm\vec\dot\int\sum
    \begin{cases}\end{cases}\text\sin\begin{array}\end{array}\over\big xtqL\theta\omega 12\cdots
    \mathbb{d}{t}(t)\left.\right|_{x=0}\dd\pdv\qty""",
)


@settings(max_examples=300, deadline=None)
@given(st.lists(st.sampled_from(PIECES), max_size=25).map("".join))
def test_nothing_that_is_typed_breaks_the_reader(source):
    for line in read(source, OWN, Habits(PACKAGES)):
        assert (line.equation is None) == bool(line.problem)
        if line.equation is not None:
            assert text(line.equation, "typed")
            assert latex(line.equation, "typed")


@pytest.mark.parametrize(
    ("source", "read_as"),
    [
        # a derivative acts on all of the power behind it
        (r"\frac{d}{dt} r^2 = 2r\dot r", "d/dt (r²) = 2rṙ"),
        (r"\frac{d}{dx}(x + 1)^2 = 2", "d/dx ((x + 1)²) = 2"),
        (r"\frac{d}{dt}\sin\theta = \dot\theta\cos\theta", "d/dt (sin θ) = θ̇ cos θ"),
        (r"\frac{d}{dt}\cos\omega t = 0", "d/dt (cos(ωt)) = 0"),
        (r"\frac{d}{dt}\frac{d}{dt}x = 0", "ẍ = 0"),
    ],
)
def test_what_a_derivative_acts_on(source, read_as):
    [line] = read(source, OWN)
    assert line.equation is not None
    assert text(line.equation, "typed") == read_as


def test_what_a_derivative_of_a_function_acts_on_is_not_guessed():
    [line] = read(r"y = \frac{d}{dt}\sin\theta\dot\phi", OWN)
    assert line.problem == "the derivative could go on here: put brackets"


@pytest.mark.parametrize(
    ("source", "problem"),
    [
        (r"\vec p = (\frac Ec, \mathbf p)", "p in bold type, and with an arrow"),
        (r"F = \sum_{n>0} f_n\cos(n\omega t) + g_n\sin(n\omega t)", "the sum over an index"),
        (r"\frac{dEc}{dt} = 0", "Ec: a word or a product?"),
        (r"\mathrm{d}Ep = -\delta W", "Ep: an energy, or a product?"),
    ],
)
def test_what_could_be_two_things_is_not_read(source, problem):
    [line] = read(source, OWN)
    assert line.equation is None
    assert line.problem.startswith(problem)


def test_an_index_of_a_sum_may_stand_in_what_a_letter_is_a_function_of():
    [line] = read(r"H = \sum_i p_i\dot q_i - L(q_i, \dot q_i)", OWN)
    assert line.equation is not None
