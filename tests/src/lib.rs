//! Problems with their exact solutions, and one checker for every stepper.
