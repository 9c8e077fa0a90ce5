//! Pictures from anywhere, as `raytree cost --reference` reads them: PFM and PNG files with bytes changed are a picture or
//! one clear message, within bounds.

use raytree::math::Rgb;
use raytree::scene::limits::size_problem;
use raytree::tracer::Film;
use raytree::tracer::image::{pfm, png};

use super::bytes;
use super::dice::Dice;
use super::laws::{FACTOR, catch_panics, without_panic};
use super::memory::counted;

/// Bytes that deflate makes of one at most. A PNG file is packed, so its pixels bound the memory: 64 bytes for each that it claims
/// and that can be in it, at one bit each.
const EXPANDED: u64 = 1032;
/// What unpacking takes in any case.
const UNPACKING: u64 = 256 << 10;

fn well_formed() -> Vec<Vec<u8>> {
    let film = |width: u32, height: u32| Film {
        width,
        height,
        pixels: (0..width * height)
            .map(|i| Rgb::new(f64::from(i), 0.5, 1e-3))
            .collect(),
        ..Film::default()
    };
    let grey = |n: u32| -> Vec<u8> { (0..n).map(|i| i as u8).collect() };
    vec![
        pfm::encode(&film(3, 2)),
        pfm::encode(&film(16, 9)),
        b"Pf\n2 1\n1.0\n\x3f\x80\0\0\0\0\0\0".to_vec(),
        png::encode(&film(3, 2), 1.0).expect("a picture"),
        png::encode(&film(40, 30), 1.0).expect("a picture"),
        png::encode_grey(9, 7, &grey(63)).expect("a picture"),
    ]
}

/// CRC-32 as in PNG (ISO 3309), bit by bit.
fn crc(bytes: &[u8]) -> u32 {
    let step = |crc: u32, byte: &u8| {
        (0..8).fold(crc ^ u32::from(*byte), |c, _| {
            (c >> 1) ^ (0xedb8_8320 & (c & 1).wrapping_neg())
        })
    };
    !bytes.iter().fold(!0, step)
}

/// Makes the sums of all chunks of a PNG file right again, so that what is in them is looked at.
fn with_right_sums(file: &mut [u8]) {
    let mut at = 8;
    while let Some(length) = file.get(at..at + 4).and_then(|b| b.try_into().ok()) {
        let end = (at + 8).saturating_add(u32::from_be_bytes(length) as usize);
        let Some(sum) = file.get(at + 4..end).map(crc) else {
            return;
        };
        let Some(place) = file.get_mut(end..end + 4) else {
            return;
        };
        place.copy_from_slice(&sum.to_be_bytes());
        at = end + 4;
    }
}

/// How many pixels a PNG file says it has.
fn claimed(file: &[u8]) -> u64 {
    let number = |at: usize| file.get(at..at + 4).and_then(|b| b.try_into().ok());
    let [width, height] = [16, 20].map(|at| number(at).map_or(0, u32::from_be_bytes));
    u64::from(width) * u64::from(height)
}

fn check(file: &[u8]) -> Result<bool, String> {
    let is_png = file.starts_with(b"\x89PNG");
    let read = || {
        if is_png {
            png::decode(file, 1.0)
        } else {
            pfm::decode(file)
        }
    };
    let (read, memory) = without_panic(|| Ok(counted(read))).map_err(|broken| broken.how)?;
    let most = if is_png {
        (UNPACKING + 64 * claimed(file).min(8 * EXPANDED * file.len() as u64)) as usize
    } else {
        (64 << 10) + FACTOR * file.len()
    };
    if memory.peak > most {
        return Err(format!("{} bytes of memory", memory.peak));
    }
    match &read {
        Ok(film) => {
            let pixels = film.width as usize * film.height as usize;
            let whole =
                film.pixels.len() == pixels && size_problem(film.width, film.height).is_none();
            let finite = film.pixels.iter().all(|p| p.is_finite());
            if !whole || !finite {
                return Err(format!("{}x{}, finite: {finite}", film.width, film.height));
            }
        }
        Err(said) if said.trim().is_empty() || said.contains('\n') => {
            return Err(format!("not one line: {said:?}"));
        }
        Err(_) => {}
    }
    Ok(read.is_ok())
}

#[test]
fn whatever_is_in_a_picture_it_is_one_or_a_message() {
    catch_panics();
    let known = well_formed();
    for file in &known {
        assert_eq!(check(file), Ok(true));
    }
    let many = std::env::var_os("RAYTREE_FUZZ").is_some();
    let (mut taken, mut refused) = (0, 0);
    for number in 0..if many { 1_000_000 } else { 4000 } {
        let dice = &mut Dice::new(11, number);
        let mut file = known[dice.below(known.len())].clone();
        let other = &known[dice.below(known.len())];
        bytes::change(dice, &mut file, other);
        if dice.one_in(2) {
            with_right_sums(&mut file);
        }
        match check(&file) {
            Ok(true) => taken += 1,
            Ok(false) => refused += 1,
            Err(how) => panic!("picture {number}: {how}: {file:?}"),
        }
    }
    println!("{taken} pictures, {refused} messages");
    assert!(taken > 20 && refused > 200, "{taken}, {refused}");
}

/// A few bytes that claim to be many pixels are refused before there is room for them.
#[test]
fn a_small_file_is_no_large_picture() {
    catch_panics();
    let mut file = png::encode_grey(9, 7, &[0; 63]).expect("a picture");
    for size in [[16384, 4096], [60_000, 60_000], [u32::MAX, 1], [0, 0]] {
        file[16..20].copy_from_slice(&u32::to_be_bytes(size[0]));
        file[20..24].copy_from_slice(&u32::to_be_bytes(size[1]));
        with_right_sums(&mut file);
        let (read, memory) = counted(|| png::decode(&file, 1.0));
        assert!(read.is_err(), "{size:?}");
        assert!(memory.peak < UNPACKING as usize, "{size:?}: {memory:?}");
    }
}
