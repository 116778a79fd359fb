import pathlib

import pytest

import mixity

ROOT = pathlib.Path(__file__).parents[2]


@pytest.fixture
def root():
    return ROOT


@pytest.fixture
def program():
    return ROOT / "build/release/src/mixity"


@pytest.fixture
def data():
    """Ten points of two runs, with units and an uncertain modulus."""
    T = [0.0, 10, 20, 30, 40, 0, 8, 16, 24, 32]
    P = [4.68] * 5 + [2.31] * 5
    contact = (9.42e-3, 2.133e6, 27e-3)
    A = mixity.area("c", 0.008, [p * 1e-3 for p in P], [t * 1e-3 for t in T], contact=contact) * 1e6
    scatter = [1.002, 0.999, 1.001, 0.998, 1.0, 0.999, 1.001, 1.0, 1.002, 0.998]
    return mixity.Dataset(
        P=P,
        T=T,
        A=A * scatter,
        units={"P": "mN", "T": "mN", "A": "mm^2"},
        radius="9.42 mm",
        modulus="2.133 MPa +/- 3%",
        toughness="27 mJ/m^2",
    )
