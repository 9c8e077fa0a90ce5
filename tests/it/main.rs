//! What the whole program promises, by subject. One test program, since each takes seconds to link.

#[path = "../common/mod.rs"]
mod common;
#[path = "../common/floor.rs"]
mod floor;
#[path = "../common/from_text.rs"]
mod from_text;
#[path = "../common/random.rs"]
mod random;

mod accel;
mod adaptive_neighbours;
mod addresses;
mod area_lights;
mod arithmetic;
mod bad_scenes;
mod book;
mod bsp_sah;
mod changes;
mod claimed_errors;
mod cli;
mod cost;
mod diff;
mod document;
mod effects;
mod estimates;
mod exporters;
mod find;
mod flat;
mod formula_edges;
mod glass_slab;
mod gouraud;
mod grade;
mod grade_outputs;
#[cfg(unix)]
mod grade_run;
mod hard_cases;
mod hello;
mod hooks;
mod html;
mod instances;
mod knobs;
mod laws;
mod lesson_features;
mod lessons;
mod light_extremes;
mod limits;
mod media;
#[cfg(unix)]
mod monday;
mod obj;
mod parts;
mod patched;
mod penumbra;
mod plain_words;
mod projected;
mod raster;
mod ray_lines;
mod read_trees;
mod readme;
mod reduce;
mod resting;
mod same_bits;
mod sampling;
mod scenes;
mod self_hits;
mod shapes;
mod show;
mod solutions;
mod spd;
mod stepping;
mod tidy;
mod tui;
mod warnings;
mod work_counts;
