"""What is drawn, as values: frame, camera, scene, picture. NumPy alone."""
