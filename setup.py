"""Packages and what lies beside their modules are found; `derivations` goes inside of rigidtop."""

from setuptools import find_packages, setup

setup(
    packages=[
        *find_packages(include=["rigidtop", "rigidtop.*"]),
        *(f"rigidtop.{name}" for name in find_packages(include=["derivations", "derivations.*"])),
    ],
    package_dir={"rigidtop.derivations": "derivations"},
    # Styles, pages, grammars: all but .py and .pyc.
    package_data={"": ["py.typed", "*.[!p]*", "*/*.[!p]*", "chapters/*/*"]},
    include_package_data=False,
)
