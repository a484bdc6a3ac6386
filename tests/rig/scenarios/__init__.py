"""What is tried on real kernels: one function a scenario, which says its figures and raises when something is wrong."""
