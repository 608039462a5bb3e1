//! Backend for PNG that places letters by their font.
//!
//! The bitmap backend of plotters draws each letter without its left side bearing, so that spaces
//! between letters are uneven.

use std::sync::LazyLock;

use ab_glyph::{Font, FontRef, ScaleFont};
use plotters::prelude::*;
use plotters_backend::text_anchor::{HPos, VPos};
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingErrorKind,
};

/// Font of all texts; `None` if it cannot be parsed.
static LETTERS: LazyLock<Option<FontRef<'static>>> =
    LazyLock::new(|| FontRef::try_from_slice(epaint_default_fonts::UBUNTU_LIGHT).ok());

/// Bitmap with letters by their font.
pub(super) struct Raster<'a>(pub BitMapBackend<'a>);

type Error<'a> = DrawingErrorKind<<BitMapBackend<'a> as DrawingBackend>::ErrorType>;

impl<'a> DrawingBackend for Raster<'a> {
    type ErrorType = <BitMapBackend<'a> as DrawingBackend>::ErrorType;

    fn get_size(&self) -> (u32, u32) {
        self.0.get_size()
    }

    fn ensure_prepared(&mut self) -> Result<(), Error<'a>> {
        self.0.ensure_prepared()
    }

    fn present(&mut self) -> Result<(), Error<'a>> {
        self.0.present()
    }

    fn draw_pixel(&mut self, at: BackendCoord, color: BackendColor) -> Result<(), Error<'a>> {
        self.0.draw_pixel(at, color)
    }

    fn draw_line<S: BackendStyle>(
        &mut self,
        from: BackendCoord,
        to: BackendCoord,
        style: &S,
    ) -> Result<(), Error<'a>> {
        self.0.draw_line(from, to, style)
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        upper_left: BackendCoord,
        bottom_right: BackendCoord,
        style: &S,
        fill: bool,
    ) -> Result<(), Error<'a>> {
        self.0.draw_rect(upper_left, bottom_right, style, fill)
    }

    fn draw_text<S: BackendTextStyle>(
        &mut self,
        text: &str,
        style: &S,
        at: BackendCoord,
    ) -> Result<(), Error<'a>> {
        let Some(font) = LETTERS.as_ref() else { return self.0.draw_text(text, style, at) };
        let (width, height) = self.estimate_text_size(text, style)?;
        let (width, height) = (width as i32, height as i32);
        let anchor = style.anchor();
        let across = match anchor.h_pos {
            HPos::Left => 0,
            HPos::Right => -width,
            HPos::Center => -width / 2,
        };
        let up = match anchor.v_pos {
            VPos::Top => 0,
            VPos::Center => -height / 2,
            VPos::Bottom => -height,
        };
        let (turned, color, size) = (style.transform(), style.color(), self.get_size());
        for (x, y, cover) in covered(font, style.size() as f32, text) {
            let (x, y) = turned.transform(x + across, y + up);
            let (x, y) = (at.0 + x, at.1 + y);
            if (0..size.0 as i32).contains(&x) && (0..size.1 as i32).contains(&y) {
                let alpha = color.alpha * f64::from(cover);
                self.0.draw_pixel((x, y), BackendColor { alpha, ..color })?;
            }
        }
        Ok(())
    }
}

/// Returns the pixels of a line of text with the covered fraction of each. The baseline is as far
/// below the top as in plotters.
fn covered(font: &FontRef<'_>, size: f32, text: &str) -> Vec<(i32, i32, f32)> {
    let scaled = font.as_scaled(size);
    let (mut pen, mut last, mut pixels) = (0.0, None, Vec::new());
    for letter in text.chars() {
        let mut glyph = scaled.scaled_glyph(letter);
        pen += last.map_or(0.0, |last| scaled.kern(last, glyph.id));
        last = Some(glyph.id);
        glyph.position = ab_glyph::point(pen, size / 2.0);
        pen += scaled.h_advance(glyph.id);
        if let Some(outline) = scaled.outline_glyph(glyph) {
            let corner = outline.px_bounds().min;
            let at = |x: u32, y: u32| (corner.x as i32 + x as i32, corner.y as i32 + y as i32);
            outline.draw(|x, y, cover| pixels.push((at(x, y).0, at(x, y).1, cover)));
        }
    }
    pixels
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the first and last column of pixels.
    fn ends(text: &str) -> (i32, i32) {
        let font = LETTERS.as_ref().expect("a font");
        let pixels = covered(font, 100.0, text);
        let columns = pixels.iter().filter(|(_, _, cover)| *cover > 0.5).map(|(x, ..)| *x);
        columns.fold((i32::MAX, i32::MIN), |(low, high), x| (low.min(x), high.max(x)))
    }

    /// A letter between bars stays between them at its own bearings.
    #[test]
    fn letters_have_their_bearings() {
        let font = LETTERS.as_ref().expect("a font").as_scaled(100.0);
        for letter in ['1', 'i', 'l', 'w', 'm'] {
            let glyph = font.scaled_glyph(letter);
            let bounds = font.outline_glyph(glyph.clone()).expect("an outline").px_bounds();
            let (low, high) = ends(&letter.to_string());
            assert!((low - bounds.min.x as i32).abs() <= 1, "{letter}: {low}");
            assert!(high as f32 <= font.h_advance(glyph.id), "{letter}: {high}");
            assert!(low > 0 || letter == 'w', "{letter}: {low}");
        }
        // Two letters are as far apart as their advance.
        assert_eq!(ends("11").0, ends("1").0);
        let advance = font.h_advance(font.glyph_id('1'));
        assert!(((ends("11").1 - ends("1").1) as f32 - advance).abs() <= 1.0);
    }
}
