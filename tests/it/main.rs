//! One integration binary: every test of the compiler through its public interface.

mod campaigns;
mod certificates;
mod cli;
mod codes;
mod conflicts;
mod controllability;
mod errors;
mod flights;
mod geometry_properties;
mod hostile;
mod idle_rotors;
mod intervals;
mod model;
mod parallel_rows;
mod planning;
mod programs;
mod pseudo_inverse;
mod render;
mod reproduction;
mod schemas;
mod simulate;
mod stages;
mod syntax;
mod trajectories;
mod vehicles;
mod volumes;
