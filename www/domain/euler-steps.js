/** The steps of Euler's method that can be drawn beside an arc, in seconds; the course report has the first. */
export const EULER_STEPS = [0.01, 0.1, 0.25, 0.5];
