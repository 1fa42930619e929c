//! Vehicles as other tools read them: one module for each format. `import` reads both back.

pub mod mjcf;
pub mod px4_params;
