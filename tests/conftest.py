"""Times are measured by the benchmarks, never by a test; draws are the same in every run."""

from hypothesis import settings

# What lands has passed what is run again.
settings.register_profile("same", deadline=None, derandomize=True)
# Other draws each time: `pytest --hypothesis-profile=other`.
settings.register_profile("other", deadline=None, derandomize=False)
settings.load_profile("same")
