"""What is read of a formula, shown as plain text."""

from __future__ import annotations

import pytest

from rigidtop.read.statements import readings, statements
from rigidtop.tree.plain import plain
from rigidtop.tree.statement import Statement, Unread


def shown(text: str) -> list[str]:
    return [
        f"unread: {each.reason}" if isinstance(each, Unread) else plain(each)
        for each in statements(text)
    ]


@pytest.mark.parametrize(
    ("text", "plainly"),
    [
        (r"\dot x_1^2 + \frac12 m v^2", "ẋ₁² + ½ m v²"),
        (r"m\dot{\mathbf r}_i'^2 + \ddot q'", "m ṙᵢ′² + q̈′"),
        (r"\SI{9.8}{\meter\per\second\squared} + \qty{3}{\kilogram}", "9.8 m s⁻² + 3 kg"),
        (r"9.81\,\frac{\mathrm m}{\mathrm s^2} + 2\,{\rm s}", "9.81 m/s² + 2 s"),
        (r"3\,\mathrm{\frac{m}{s}} + 3\,\text{ms}^{-1}", "3 m/s + 3 m s⁻¹"),
        (r"{x + 1 \over y} + {1 \over \sqrt{a \over b}}", "(x + 1)/y + 1/√(a/b)"),
        (r"\frac{d}{dt}\frac{\partial L}{\partial\dot\theta}", "d(∂L/∂θ̇)/dt"),
        (r"d/dt(∂L/∂θ̇) = ∂L/∂θ", "d(∂L/∂θ̇)/dt = ∂L/∂θ"),
        (r"\frac{\partial^2 L}{\partial x\,\partial\dot y}", "∂²L/∂x∂ẏ"),
        (r"\sin^2\theta\cos\omega t + B", "sin² θ cos(ω t) + B"),
        (r"\sin\theta\,\dot\phi + \sin\theta(a+b)", "sin θ φ̇ + sin θ (a + b)"),
        (r"\tan^{-1} x", "arctan x"),
        (r"MgR/\lambda_3\omega_3", "M g R/(λ₃ ω₃)"),
        (r"\lambda_3/\lambda_1\,\omega_3", "λ₃/λ₁ ω₃"),
        (r"1/2 m v^2", "½ m v²"),
        (r"\int_0^R r^2\,dr", "∫_{0}^{R} r² dr"),
        (
            r"\int_0^{\pi}\int_0^a \underbrace{r^2}_{s^2} \underbrace{r\,dr\,d\theta}_A",
            "∫_{0}^{π} ∫_{0}^{a} (r²)⟦s²⟧ r⟦A⟧ dr dθ",
        ),
        (r"\left(\frac{d\mathbf L}{dt}\right)_{\rm body}", "(dL/dt)_body"),
        (r"U(r) - V'(x) + m(g+a)", "U(r) − V′(x) + m (g + a)"),
        (r"1.08\cdot 10^{-4}\,\mathrm{kg\,m^2/s}", "1.08 · 10⁻⁴ kg m²/s"),
        (r"\begin{pmatrix} a & b\\ c & d\end{pmatrix}\mathbf e_3", "(a, b; c, d) e₃"),
        (r"\left.\frac{d\mathbf L}{dt}\right|_{\text{body}}", "(dL/dt)_body"),
        (r"\left(\frac{d}{dt}\right)_{S} \mathbf L", "(dL/dt)_S"),
        (r"\frac{d}{dt}\Big|_{\text{rot}}\mathbf r", "(dr/dt)_rot"),
        (
            r"\frac{d}{dt} \left[ m r^2 \dot\phi \right] - \frac{d}{dt} x \cdot y",
            "d(m r² φ̇)/dt − dx/dt · y",
        ),
        (r"dx/dt + d^2x/dt^2 + \mathrm{d}y/\mathrm{d}t", "dx/dt + d²x/dt² + dy/dt"),
        (r"\partial_t x + \partial L/\partial \dot q", "∂x/∂t + ∂L/∂q̇"),
        (
            r"\left.\partial V/\partial x\right|_{x_0} + \frac{\partial f}{\partial t}|_{x=0}",
            "∂V/∂x|_{x_0} + ∂f/∂t|_{x = 0}",
        ),
        (
            r"\dv[2]{x}{t} + \pdv{L}{q} + \dv{t} x + \qty(a+b) \vb{r} \cross \vb*{p} + \abs{x}",
            "d²x/dt² + ∂L/∂q + dx/dt + (a + b) r × p + |x|",
        ),
        (r"M'(x) f''(x) + \phi'^2 + \theta''", "M′(x) f′′(x) + φ′² + θ′′"),
        (
            r"\cos\frac\theta2 + \cos wt + \sin(\alpha)\cos\beta",
            "cos(θ/2) + cos(w t) + sin α cos β",
        ),
        (
            r"\ln\frac{a}{b} + \log_{10} x + \operatorname{tr} A + \operatorname{Im} z",
            "ln(a/b) + log_10 x + tr A + Im z",
        ),
        (
            r"\sqrt[3]{x} + \sqrt2 + 2/3 x + \frac{\frac{a}{b}}{c} + 1/(2m)p^2",
            "³√(x) + √(2) + ⅔ x + a/b/c + 1/(2 m) p²",
        ),
        (
            r"3\ \mathrm{s^{-1}} + \SI{7.3e-5}{rad/s} + 5\,\text{m} + 1{,}5 + 30^\circ",
            "3 s⁻¹ + 7.3 · 10⁻⁵ rad/s + 5 m + 1.5 + 30 °",
        ),
        (
            r"|a| + \left\lVert\mathbf r\right\rVert + \langle x^2\rangle + |\mathbf a||\mathbf b|",
            "|a| + |r| + ⟨x²⟩ + |a| |b|",
        ),
        (
            r"(a,b,c)^T + \begin{bmatrix}1\\2\end{bmatrix}^\top + A^{\mathrm T} R^{-1}",
            "(a, b, c)ᵀ + [1; 2]ᵀ + Aᵀ R⁻¹",
        ),
        (r"(\boldsymbol\omega\times\mathbf L)_1", "(ω × L)₁"),
        (
            r"\underbrace{m R^2}_{J} + \underbrace{a}_{\text{small}} + \boxed{c}",
            "(m R²)⟦J⟧ + a⟦small⟧ + c",
        ),
        (
            r"\sum_i m_i r_i^2 + \sum_{i=1}^N F_i + \prod_k x_k",
            "Σ_{i} mᵢ rᵢ² + Σ_{i=1}^{N} Fᵢ + Π_{k} xₖ",
        ),
        (
            r"\int F\cdot d\mathbf r + \int dr\,r+\int \frac{dx}{\sqrt x}+\int\!\!\int f\,dx\,dy",
            "∫ F dr + ∫ r dr + ∫ 1/√(x) dx + ∫ ∫ f dx dy",
        ),
        (r"\int_0^{2\pi}\!d\phi\int_0^\pi\sin\theta\,d\theta", "∫_{0}^{2 π} ∫_{0}^{π} sin θ dθ dφ"),
        (
            r"\lim_{x\to0}\frac{\sin x}{x} + O(\epsilon^2) + \mathcal O(x^3)",
            "lim_{x→0} sin x/x + O(ε²) + O(x³)",
        ),
        (
            r"\nabla V + \nabla\cdot\mathbf E + \nabla\times\mathbf B + \nabla^2\phi - \vec\nabla",
            "∇V + ∇· E + ∇× B + ∇² φ − ∇",
        ),
        (
            r"U(r) + L(q,\dot q) + x(t) + \omega_1(0) + E(0) + m(g + a) + L(1+x) + \theta(t=0)",
            "U(r) + L(q, q̇) + x(t) + ω₁(0) + E(0) + m (g + a) + L (1 + x) + θ(0)",
        ),
        (r"\dot{\mathbf e}_r + \dot{\vec r}^2 + θ̇² + F⃗", "ė_r + ṙ² + θ̇² + F"),
        (
            r"V_{\rm eff} \mathbf e_1' e_{1'} \Omega_{1,2} \Delta x {\cal L} \mathcal O",
            "V_eff e₁′ e_{1′} Ω_{1,2} Δx ℒ 𝒪",
        ),
        (
            r"\left(\begin{array}{cc}1&0\\0&1\end{array}\right) {\bf a} + v^2_0 + x_1^{\prime 2}",
            "(1, 0; 0, 1) a + v₀² + x₁′²",
        ),
        (r"E\,dx + \mathrm{d}Q", "E dx + dQ"),
        (
            r"\sin\theta\dot\phi\cos\theta + \sin\theta\mathbf e_1 + e^{i\omega t} + a \pm b \mp c",
            "sin θ φ̇ cos θ + sin θ e₁ + e^(i ω t) + a ± b ∓ c",
        ),
    ],
)
def test_an_expression(text: str, plainly: str) -> None:
    assert shown(text) == [plainly]


@pytest.mark.parametrize(
    ("text", "plainly"),
    [
        (r"a = b \approx c, \quad d \Rightarrow e", ["a = b ≈ c", "d", "e"]),
        (
            r"\begin{align} a &= b \\ &\quad + d \\ &= e \end{align}",
            ["a = b + d", "b + d = e"],
        ),
        (
            r"f = \begin{cases} 1 & x>0\\ 2 & \text{otherwise}\end{cases}",
            ["f = 1  (x > 0)", "f = 2"],
        ),
        (r"a = b \qquad (\theta \ne 0)", ["a = b  (θ ≠ 0)"]),
        (r"\mathbf{L = r\times p}", ["L = r × p"]),
        (r"(*)", []),
        ("=", []),
        (r"x = , y = 2", ["unread: a term is missing before ,", "y = 2"]),
        (r"= b", ["… = b"]),
        (r"a := b \equiv c \leadsto d = e => f \ne g", ["a ≡ b ≡ c", "d = e", "f ≠ g"]),
        (r"a = b \text{ and } c = d \quad\text{und}\quad e = f.", ["a = b", "c = d", "e = f"]),
        (r"x = A\cos\omega t \quad\text{if } A > 0, y = z", ["x = A cos(ω t)  (A > 0)  (y = z)"]),
        (r"\begin{multline} a = b + c \\ + d - e \\ - f \end{multline}", ["a = b + c + d − e − f"]),
        (r"\begin{aligned} a &= b \\ -c &= d \end{aligned}", ["a = b", "−c = d"]),
        (
            r"\begin{eqnarray} a &=& b \nonumber\\ &=& c \label{z} \end{eqnarray}",
            ["a = b", "b = c"],
        ),
        (
            r"\left\{\begin{aligned} \dot x &= y \\ \dot y &= -x \end{aligned}\right.",
            ["ẋ = y", "ẏ = −x"],
        ),
        (
            r"f = \left\{\begin{array}{ll} 1 & \text{for } x>0\\ 0 & \text{else}\end{array}\right.",
            ["f = 1  (x > 0)", "f = 0"],
        ),
        (r"a &= b, & c &= d \\ e &= f, & g &= h", ["a = b", "c = d", "e = f", "g = h"]),
        (r"a = b \rightarrow c = d", ["a = b", "c = d"]),
        (r"E = \mathrm{const} = \text{const.} = const", ["E = const = const = const"]),
        (r"x = 1, 2, 3", ["x = (1, 2, 3)"]),
        (r"m = 0,5\,\mathrm{kg}", ["m = 0.5 kg"]),
        (r"\omega = (0,0,1)", ["ω = (0, 0, 1)"]),
        (r"\omega_1, \omega_2 \ll \omega_3", ["(ω₁, ω₂) ≪ ω₃"]),
        (r"T=2\pi/\omega\;\;\;\;\boxed{a = b}", ["T = 2 π/ω", "a = b"]),
        (r"x > 0 \;\forall t", ["x > 0"]),
        (r"\sin\theta\approx\theta \text{ for small } \theta", ["sin θ ≈ θ"]),
        (r"A \Big( a + b \\ &\quad + c \Big) = d", ["A (a + b + c) = d"]),
        (r"0 = {} & a \\ & + b", ["0 = a + b"]),
        (r"|x|<1 \Leftrightarrow -1<x<1", ["|x| < 1", "−1 < x < 1"]),
        (r"a = b \qquad (3.48)", ["a = b"]),
        (r"n! = 1, a = 2", ["unread: a factorial", "a = 2"]),
    ],
)
def test_statements(text: str, plainly: list[str]) -> None:
    assert shown(text) == plainly


def test_a_row_goes_on_from_the_one_above() -> None:
    first, second = statements(r"\begin{align} a &= b \\ &= c \tag{2}\end{align}")
    assert isinstance(second, Statement)
    assert second.continues
    assert (first.tag, second.tag, second.position) == ("", "2", 25)


def test_other_readings_come_behind_the_usual_one() -> None:
    texts = [plain(each) for read in readings("a/bc = M(x)") for each in read]  # type: ignore[arg-type]
    assert texts == ["a/(b c) = M(x)", "a/(b c) = M (x)", "a/b c = M(x)"]


@pytest.mark.parametrize(
    "text",
    [
        "(" * 500,
        "(" * 500 + "x" + ")" * 500,
        r"\sqrt" * 500 + "x",
        "x^" * 300 + "2",
        "a/" * 1000 + "b",
        "d x/" * 300 + "dt",
        r"\left(" * 300 + "x" + r"\right)" * 300,
        r"\left,x\right=",
        r"\begin{cases} a",
        "a = b}",
        r"\int x",
        "|x",
        "∂",
    ],
)
def test_what_is_no_formula_has_a_reason(text: str) -> None:
    assert any(isinstance(each, Unread) and each.reason for each in statements(text))


@pytest.mark.parametrize(
    "text",
    [r"\frac{d^2x}{dt}", r"\frac{dx}{dt^2}", r"\frac{\partial^3 f}{\partial x^2}", "d^2x/dt"],
)
def test_a_derivative_is_of_one_order(text: str) -> None:
    [statement] = statements(f"{text} = 0")
    assert isinstance(statement, Unread)
    assert "order" in statement.reason
