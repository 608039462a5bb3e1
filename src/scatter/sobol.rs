//! Sobol points and their nested uniform scrambling.

use super::ScatterError;
use super::hash::{hash, unit};

/// Maximum number of dimensions.
pub const MAX_DIMENSIONS: usize = 512;

/// Number of binary digits of the points.
const BITS: usize = 32;

/// The Sobol sequence, in base 2.
///
/// Point i has the coordinates sum of v_k over the digits k of the Gray code of i, with the
/// direction numbers of Joe and Kuo (2008). The first 2^m points are a (t, m, s)-net.
#[derive(Debug, Clone)]
pub struct Sobol {
    /// Direction numbers, as fractions of 2^32, [`BITS`] for each dimension.
    directions: Vec<[u32; BITS]>,
}

impl Sobol {
    /// Creates the sequence.
    ///
    /// # Errors
    /// [`ScatterError::Dimensions`] above [`MAX_DIMENSIONS`].
    pub fn new(dimensions: usize) -> Result<Self, ScatterError> {
        if dimensions > MAX_DIMENSIONS {
            return Err(ScatterError::Dimensions(dimensions));
        }
        let table = include_str!("direction_numbers.txt");
        let lines = table.lines().filter(|line| !line.starts_with('#'));
        let first = std::array::from_fn(|k| 1 << (BITS - 1 - k));
        let others = lines.map(directions);
        let directions = std::iter::once(first).chain(others).take(dimensions).collect();
        Ok(Self { directions })
    }

    /// Returns the number of dimensions.
    #[must_use]
    pub fn dimensions(&self) -> usize {
        self.directions.len()
    }

    /// Returns a coordinate of a point, as a fraction of 2^32.
    #[must_use]
    pub fn digits(&self, index: u32, dimension: usize) -> u32 {
        let mut gray = index ^ (index >> 1);
        let mut digits = 0;
        while gray != 0 {
            digits ^= self.directions[dimension][gray.trailing_zeros() as usize];
            gray &= gray - 1;
        }
        digits
    }
}

/// Computes direction numbers from a line `a m_1 .. m_s`:
///
/// ```text
/// m_k = 2 a_1 m_(k-1) ^ 4 a_2 m_(k-2) ^ .. ^ 2^s m_(k-s) ^ m_(k-s)     v_k = m_k/2^k
/// ```
fn directions(line: &str) -> [u32; BITS] {
    let mut numbers = line.split(' ').map(|number| number.parse::<u32>().unwrap_or_default());
    let inner = numbers.next().unwrap_or_default();
    let given: Vec<u32> = numbers.collect();
    let degree = given.len();
    let mut directions = [0; BITS];
    for k in 0..BITS {
        if let Some(number) = given.get(k) {
            directions[k] = number << (BITS - 1 - k);
            continue;
        }
        let oldest = directions[k - degree];
        let mut direction = oldest ^ (oldest >> degree);
        for j in 1..degree {
            if (inner >> (degree - 1 - j)) & 1 == 1 {
                direction ^= directions[k - j];
            }
        }
        directions[k] = direction;
    }
    directions
}

/// Sobol points after Owen's nested uniform scrambling.
///
/// Each binary digit of a coordinate is flipped by a random bit that depends on all digits before
/// it. Points stay a net, and each of them is uniformly distributed, so that means over them are
/// unbiased; different seeds give independent scramblings. Digits beyond those of the points are
/// random, so coordinates have 52 digits.
///
/// Source: A. B. Owen: Randomly permuted (t,m,s)-nets and (t,s)-sequences, in: Monte Carlo and
/// Quasi-Monte Carlo Methods in Scientific Computing, 1995.
#[derive(Debug, Clone)]
pub struct ScrambledSobol {
    sobol: Sobol,
    seed: u64,
}

/// Number of digits whose flips come from one hash: a tree of six levels has 63 inner nodes.
const LEVELS: u32 = 6;

impl ScrambledSobol {
    /// Creates a scrambling of a sequence.
    #[must_use]
    pub fn new(sobol: Sobol, seed: u64) -> Self {
        Self { sobol, seed }
    }

    /// Returns a coordinate of a point, between 0 and 1.
    #[must_use]
    pub fn coordinate(&self, index: u32, dimension: usize) -> f64 {
        let key = hash(&[self.seed, dimension as u64]);
        let digits = self.sobol.digits(index, dimension);
        let mut scrambled = 0;
        let mut depth = 0;
        while depth < BITS as u32 {
            let levels = LEVELS.min(BITS as u32 - depth);
            // Digits before this group, with a leading one that tells lengths apart.
            let prefix = (1_u64 << depth) | (u64::from(digits) >> (BITS as u32 - depth));
            let flips = hash(&[key, prefix]);
            // Nodes of the tree are numbered as in a heap, from 1.
            let mut node = 1_u32;
            for level in depth..depth + levels {
                let digit = (digits >> (BITS as u32 - 1 - level)) & 1;
                let flip = (flips >> node) as u32 & 1;
                scrambled = (scrambled << 1) | (digit ^ flip);
                node = 2 * node + digit;
            }
            depth += levels;
        }
        let rest = hash(&[key, (1_u64 << BITS) | u64::from(digits), 1]);
        unit((u64::from(scrambled) << BITS) | (rest >> BITS))
    }
}
