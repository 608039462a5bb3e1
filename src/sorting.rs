//! Sorting by a key. The sort is compiled once here: the standard library's sort is some two
//! thousand lines of LLVM code for each closure type.

/// Sorts items by ascending numbers in the order of [`f64::total_cmp`]. The sort is stable.
pub(crate) fn sort_ascending<T>(items: &mut [T], number: impl Fn(&T) -> f64) {
    let numbers = items.iter().map(number).zip(0..).collect();
    for (place, from) in sources(numbers).into_iter().enumerate() {
        items.swap(place, from);
    }
}

/// Sorts like [`sort_ascending`], in descending order.
pub(crate) fn sort_descending<T>(items: &mut [T], number: impl Fn(&T) -> f64) {
    sort_ascending(items, |item| -number(item));
}

/// Returns for each place the index of its item, given that all places before it were filled by
/// exchanges.
fn sources(mut numbers: Vec<(f64, usize)>) -> Vec<usize> {
    numbers.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let mut sources: Vec<usize> = numbers.into_iter().map(|(_, place)| place).collect();
    for place in 0..sources.len() {
        // The item that stood here earlier was exchanged with the one from that place.
        while sources[place] < place {
            sources[place] = sources[sources[place]];
        }
    }
    sources
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn items_are_sorted_as_the_standard_library_does() {
        let mut random = fastrand::Rng::with_seed(5);
        for length in 0..60 {
            let items: Vec<(f64, usize)> =
                (0..length).map(|k| (f64::from(random.i8(-9..9)), k)).collect();
            let (mut up, mut down) = (items.clone(), items.clone());
            sort_ascending(&mut up, |item| item.0);
            sort_descending(&mut down, |item| item.0);
            let mut expected = items;
            expected.sort_by(|a, b| a.0.total_cmp(&b.0));
            assert_eq!(up, expected);
            expected.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
            assert_eq!(down, expected);
        }
        let mut odd = [f64::NAN, 1.0, f64::NEG_INFINITY, -f64::NAN];
        sort_ascending(&mut odd, |item| *item);
        assert!(odd[0].is_nan() && odd[1] == f64::NEG_INFINITY && odd[3].is_nan(), "{odd:?}");
    }
}
