"""The comparison of all methods on generated and real scenes; docs/comparison.md says what is run and how to read it."""
