//! Reads a ray tree from standard input, prints its rays, and adds up what they contribute to the pixel:
//! `cargo run --release --example trace | cargo run --release --example walk`.

use std::error::Error;

use raytree::math::Rgb;
use raytree::trace::Document;

fn main() -> Result<(), Box<dyn Error>> {
    let document: Document = serde_json::from_reader(std::io::stdin())?;
    let mut sum = Rgb::BLACK;
    for sample in &document.samples {
        for ray in sample.rays() {
            let node = ray.node;
            let indent = "  ".repeat(ray.level);
            println!("{indent}{:?} {:?}", node.kind, node.outcome);
            sum += node.contribution.unwrap_or(Rgb::BLACK) * sample.weight;
        }
    }
    println!("sum {sum:?}, pixel {:?}", document.color.linear);
    Ok(())
}
