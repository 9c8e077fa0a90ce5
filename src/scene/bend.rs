//! The catalogue of bends: mistakes that students make, each a law of this tracer with one thing exchanged.
//!
//! To add a bend: an entry here, an arm in the file of its law, and the tests tell whether it is told apart (book: "Add a bend").

use strum::{Display, EnumString, IntoStaticStr, VariantArray};

use super::law::{BendEntry, Law};

/// The enum of all bends, and the table of their entries, from one list.
macro_rules! catalogue {
    ($($law:ident { $($bend:ident $name:literal: $formula:literal, $note:literal, $tell:literal;)* })*) => {
        /// A mistake, by name.
        #[derive(
            Clone, Copy, Debug, Display, EnumString, Eq, Hash, IntoStaticStr, Ord, PartialEq, PartialOrd, VariantArray,
        )]
        pub enum Bend {
            $($(
                #[doc = $note]
                #[strum(serialize = $name)]
                $bend,
            )*)*
        }

        /// The entries, in the order of the variants.
        const ENTRIES: [BendEntry; Bend::VARIANTS.len()] = [
            $($(BendEntry {
                law: Law::$law,
                formula: $formula,
                note: $note,
                tell: $tell,
            },)*)*
        ];
    };
}

// Name; what is computed in the place of what; what is wrong, in a sentence; in which quantity it first shows.
catalogue! {
    EyeRay {
        FovFull "fov-full":
            "tan(fov) for tan(fov/2)",
            "the whole field of view is taken where half of it belongs",
            "direction of I: nearly twice as far off the axis";
        FovDegrees "fov-degrees":
            "tan of the number of degrees",
            "the field of view is not converted from degrees to radians",
            "direction of I";
        PixelCorner "pixel-corner":
            "x, y for x + 0.5, y + 0.5",
            "the eye ray goes through the corner of the pixel, not its centre",
            "direction of I: off by half a pixel everywhere";
        RowsFromBottom "rows-from-bottom":
            "y' = 2 (y + 0.5) / H - 1",
            "rows are counted from the bottom: the picture is upside down",
            "direction of I";
        ColumnsMirrored "columns-mirrored":
            "x' = 1 - 2 (x + 0.5) / W",
            "columns are counted from the right: the picture is mirrored",
            "direction of I";
        XySwapped "xy-swapped":
            "film (y, x) for (x, y)",
            "column and row are exchanged: the picture is transposed",
            "direction of I, where x is not y";
        AspectOnHeight "aspect-on-height":
            "y' times W/H, x' not",
            "the aspect ratio is applied to the height: shapes are squeezed",
            "direction of I";
        AspectForgotten "aspect-forgotten":
            "W/H = 1",
            "the aspect ratio is forgotten",
            "direction of I: x too small by W/H";
        NotCentred "not-centred":
            "right (0.5 + x) 2 tan(fov_x) / W, up (0.5 + y) 2 tan(fov_y) / H",
            "the film is not centred on the view direction",
            "direction of I";
        Fisheye "fisheye":
            "angles linear in x and y",
            "equal steps on the film are taken as equal angles",
            "direction of I: right in the middle, wrong at the corners";
        DirectionNotUnit "direction-not-unit":
            "d not normalised",
            "the direction of the eye ray is not normalised",
            "length of the direction; t too small by that factor";
    }
    Closest {
        FarthestHit "farthest-hit":
            "the largest t",
            "the farthest hit is taken, not the closest",
            "object and t of the last surface behind";
        FirstInList "first-in-list":
            "the first shape of the file that is hit",
            "the first shape in the list that is hit is taken, not the closest",
            "object and t where two overlap";
        BehindAccepted "behind-accepted":
            "t < 0 allowed, the smallest wins",
            "hits behind the origin are accepted",
            "t negative";
        FarRoot "far-root":
            "t = (-b + sqrt(disc)) / 2a",
            "the larger root of the sphere's equation is taken",
            "t of spheres, side back";
        PlaneDSign "plane-d-sign":
            "t = -(n.o - D) / (n.d) with D = -n.p",
            "the constant of the plane's equation has the wrong sign",
            "t of planes that do not go through the origin";
        EdgePlaneSlide "edge-plane-slide":
            "d_i = -V_i.n for -E_i.V_i",
            "the inside test of triangles takes the triangle's normal where the edge's belongs",
            "object: triangles vanish or grow";
        CapsForgotten "caps-forgotten":
            "the wall alone, without base and top",
            "the caps of cylinders, cones and other quadrics are forgotten",
            "part base or top: the ray goes on to the wall inside";
        FirstRootClipped "first-root-clipped":
            "the nearer root of the wall, or none if it is beyond the ends",
            "where the nearer root of a quadric lies beyond its ends, the other one is not tried",
            "object: a wall that is seen through an open end is missed";
        CsgFirstPart "csg-first-part":
            "the first crossing of part 0",
            "of a csg only the first part is met",
            "part and t where another part cuts it";
        CsgAllParts "csg-all-parts":
            "the first crossing of any part",
            "every surface of every part of a csg is met, inside the whole or not",
            "part and t where nothing is left";
    }
    Interaction {
        NormalNotTurned "normal-not-turned":
            "no change of sign on the back side",
            "the normal is not turned to the side of the ray",
            "normal where the side is back: opposite";
        NormalInward "normal-inward":
            "C - P, or corners in clockwise order",
            "normals point inwards",
            "normal: opposite on all spheres and triangles";
        NormalByMatrix "normal-by-matrix":
            "M n for the inverse transpose",
            "normals of stretched objects are transformed like points",
            "normal of stretched objects";
        NormalNotUnit "normal-not-unit":
            "P - C, or the blended normal, not divided by its length",
            "the normal is not normalised",
            "length of the normal; terms scaled";
        BarycentricRotated "barycentric-rotated":
            "(u, v, w) given to the corners (b, c, a)",
            "barycentric coordinates are given to the wrong corners",
            "normal of smooth meshes";
        Flat "flat":
            "the geometric normal for the blended one",
            "corner normals are not blended",
            "normal of smooth meshes";
        NormalRadial "normal-radial":
            "P - middle for the gradient",
            "the normal of cylinders, tori and other solids is taken as a sphere's",
            "normal of solids with curved walls";
        UvSwapped "uv-swapped":
            "(v, u) for (u, v)",
            "texture coordinates are exchanged",
            "uv";
    }
    Start {
        NoOffset "no-offset":
            "origin = P, t > 0",
            "secondary rays start on the surface itself and may hit it again",
            "L blocked by its own object, t near 0";
        OffsetInwards "offset-inwards":
            "origin = P - 1e-4 N",
            "secondary rays start below the surface",
            "L blocked by its own object, t about the offset";
    }
    Ambient {
        AmbientPerLight "ambient-per-light":
            "Ka Ia once a light",
            "the ambient term is added once for every light",
            "ambient term times the number of lights";
    }
    Illumination {
        LNotUnit "l-not-unit":
            "L = light - P",
            "L is not normalised",
            "length of L; N.L above 1";
        LReversed "l-reversed":
            "L = P - light",
            "L points from the light to the surface",
            "L opposite: lit from the wrong side";
        DirectionalReversed "directional-reversed":
            "L = the direction of the light",
            "L of a directional light is the way that the light goes, not its opposite",
            "L opposite for directional lights alone";
        AttenuationNone "attenuation-none":
            "1 for 1 / (a + b r + c r^2)",
            "light is not attenuated with distance",
            "diffuse term, by distance";
        AttenuationLinear "attenuation-linear":
            "1 / (a + b r)",
            "the quadratic part of the attenuation is forgotten",
            "diffuse term, by distance";
    }
    Shadow {
        ShadowEndless "shadow-endless":
            "t_max of L infinite",
            "things behind the light cast shadows",
            "lit: blocked by things behind the light";
        ShadowInverted "shadow-inverted":
            "the light counts if its ray hits something",
            "the shadow test is inverted",
            "lit exchanged everywhere";
        ShadowNone "shadow-none":
            "no shadow ray",
            "shadows are not tested",
            "lit where something is in the way";
        FirstLightDecides "first-light-decides":
            "the visibility of light 1 for all",
            "whether the first light is seen decides for all lights",
            "lit of the further lights";
    }
    Diffuse {
        CosMissing "cos-missing":
            "Kd I for Kd I (N.L)",
            "the cosine of the diffuse term is missing",
            "diffuse term times 1 / (N.L)";
        CosAbsolute "cos-absolute":
            "|N.L| for N.L > 0",
            "lights behind the surface shine on it by the absolute value of the cosine",
            "diffuse term where the light is behind the surface";
        CosUnclamped "cos-unclamped":
            "N.L without a test of its sign",
            "lights behind the surface take light away",
            "diffuse term below 0";
    }
    Specular {
        VNotNegated "v-not-negated":
            "R.I for R.V",
            "the highlight takes the ray's direction where the direction to the viewer belongs",
            "r_dot_v of opposite sign: no highlight where ours is";
        MirrorLHalf "mirror-l-half":
            "R = (N.L) N - L",
            "the factor 2 is missing where L is mirrored",
            "specular term";
        Halfway "halfway":
            "(N.H)^n for (R.V)^n",
            "the halfway vector is taken (Blinn's model)",
            "specular term wider";
        SpecularEven "specular-even":
            "(R.V)^n without max(0, .)",
            "a negative cosine is raised to an even power",
            "specular term opposite to the light";
        SpecularUnlit "specular-unlit":
            "specular term without N.L > 0",
            "the highlight is added where the light is behind the surface",
            "specular term where ours is absent";
        SpecularShadowed "specular-shadowed":
            "specular term although blocked",
            "the highlight is added in shadows, too",
            "specular term in shadows";
        SpecularTimesCos "specular-times-cos":
            "Ks I (N.L) (R.V)^n",
            "the specular term is multiplied by the cosine",
            "specular term times N.L";
    }
    Reflect {
        ReflectPlus "reflect-plus":
            "R = I + 2 (N.I) N",
            "the sign in the reflection is wrong: R goes into the surface",
            "direction of R";
        ReflectNo2 "reflect-no-2":
            "R = I - (N.I) N",
            "the factor 2 of the reflection is missing: R runs along the surface",
            "direction of R, not unit";
        ReflectLongNormal "reflect-long-normal":
            "R with N of length 2",
            "R is computed with a normal that is not unit",
            "direction of R, not unit";
    }
    Refract {
        EtaInverted "eta-inverted":
            "eta = n2/n1",
            "the ratio of the indices is inverted: T bends away at the entry",
            "direction of T at the entry";
        TirStraight "tir-straight":
            "T = I where k < 0",
            "under total internal reflection the ray goes straight on",
            "T present where ours is absent";
        RefractNoNormal "refract-no-normal":
            "T = eta I, normalised",
            "the part along the normal is missing: T goes straight through",
            "direction of T equals I";
    }
    Media {
        MediumNotTracked "medium-not-tracked":
            "n1 = 1, n2 = ior at the exit, too",
            "the index inside the glass is not used when the ray leaves it",
            "T right at the entry, wrong at the exit";
    }
    Shares {
        MirrorPhong "mirror-phong":
            "(R.I)^n for Kr",
            "the weight of R is a power of a cosine, not Kr",
            "weight of R";
        MirrorOne "mirror-one":
            "1 for Kr",
            "the weight of R is 1, not Kr",
            "weight of R";
        FresnelNone "fresnel-none":
            "F = 0",
            "Fresnel's share is not computed",
            "reflectance and weights";
        SchlickInside "schlick-inside":
            "Schlick with the cosine inside the glass",
            "Schlick's formula takes the cosine in the denser medium",
            "reflectance where the ray leaves the glass";
        TirBlack "tir-black":
            "R without Kt where k < 0",
            "under total internal reflection the light that would be let through is lost",
            "weight of R where k < 0";
    }
    Depth {
        DepthLessOne "depth-less-one":
            "the recursion ends one bounce early",
            "the recursion ends one bounce early",
            "rays missing at the last level";
    }
    Radiance {
        ClampEarly "clamp-early":
            "radiance clamped to 1 at each hit",
            "colours are clamped at each hit, not at the end",
            "radiance where a ray brings more than 1";
    }
    LightSamples {
        LightSum "light-sum":
            "samples of a light not divided by their number",
            "the samples of a light are added, not averaged",
            "terms of the light times the number of samples";
        CosLightMissing "cos-light-missing":
            "without cos'",
            "the cosine at the light is missing",
            "mean too large by 1 / cos'";
        AreaMissing "area-missing":
            "without A",
            "the area of the light is missing",
            "mean times 1 / A";
        DistanceMissing "distance-missing":
            "without 1 / r^2",
            "the square of the distance to the light is missing",
            "mean times r^2";
        PiMissing "pi-missing":
            "without 1 / pi",
            "the factor 1 / pi of a diffuse surface is missing",
            "mean times pi";
        MiddleOnly "middle-only":
            "all samples in the middle of the light",
            "all shadow rays go to the middle of the light",
            "lit all or nothing: no penumbra";
        SamePoints "same-points":
            "the same random points in all pixels",
            "all pixels take the same random points",
            "noise that is not independent between pixels";
    }
    Color {
        GammaTwice "gamma-twice":
            "the sRGB curve twice",
            "the sRGB curve is applied twice",
            "srgb8 too bright";
        GammaNone "gamma-none":
            "no sRGB curve",
            "the sRGB curve is not applied",
            "srgb8 too dark";
        Truncated "truncated":
            "floor(255 v) for round(255 v)",
            "channels are cut off, not rounded",
            "srgb8 lower by 1 in half of all channels";
        NotAveraged "not-averaged":
            "the sum of the samples, not their mean",
            "the sum of the samples is not divided by their number",
            "colour times the number of samples";
    }
}

impl Bend {
    /// Name, as in `--bend NAME`.
    pub fn name(self) -> &'static str {
        self.into()
    }

    /// What it is, in words.
    pub fn entry(self) -> BendEntry {
        ENTRIES[self as usize]
    }

    /// The law that it exchanges.
    pub fn law(self) -> Law {
        self.entry().law
    }

    /// All of them, in the order of the catalogue.
    pub fn all() -> impl Iterator<Item = Self> {
        Self::VARIANTS.iter().copied()
    }
}
