// Batten in C++17: objects that free themselves, spans in, vectors out, exceptions for errors. Header only, over the C interface, whose
// headers say what each call does, costs and refuses; get() gives the C object. The names are those of Python: a function of bat:: makes
// something, a method asks or changes. bindings/cpp.py writes this file from bindings/calls.txt and the headers.
//
// Objects are moved, not copied, unless copy() is asked for. Points are rows of doubles, x y [z] each. Structs and options are those of
// C: `auto options = bat_fit_defaults(); options.tolerance = 0.1;`. A status other than BAT_OK throws bat::Error; where the best result is
// handed over with BAT_TOLERANCE in a struct, it is returned and says so (within).
#ifndef BATTEN_BATTEN_HPP
#define BATTEN_BATTEN_HPP

#include <batten/batten.h>

#include <array>
#include <cstddef>
#include <cstdio>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace bat {

// What a call refused, with the status it gave.
class Error : public std::runtime_error {
  public:
    explicit Error(bat_status status) : std::runtime_error(bat_status_message(status)), status_(status) {}
    Error(bat_status status, const std::string &why) : std::runtime_error(why), status_(status) {}
    [[nodiscard]] bat_status status() const noexcept { return status_; }

  private:
    bat_status status_;
};

// Values in a row that somebody else owns: of a vector, an array, a std::span, whatever has data() and size(), or a pointer and a number.
template <class T> class Span {
  public:
    constexpr Span() noexcept = default;
    constexpr Span(T *data, std::size_t size) noexcept : data_(data), size_(size) {}
    template <class C, class = std::enable_if_t<std::is_convertible_v<
                           std::remove_pointer_t<decltype(std::data(std::declval<C &>()))> (*)[], T (*)[]>>>
    constexpr Span(C &&of) noexcept : data_(std::data(of)), size_(std::size(of)) {}
    constexpr Span(std::initializer_list<std::remove_const_t<T>> of) noexcept : data_(first(of)), size_(of.size()) {} // until the call ends
    [[nodiscard]] constexpr T *data() const noexcept { return data_; }
    [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }
    [[nodiscard]] constexpr bool empty() const noexcept { return size_ == 0; }
    [[nodiscard]] constexpr T *begin() const noexcept { return data_; }
    [[nodiscard]] constexpr T *end() const noexcept { return data_ + size_; }
    [[nodiscard]] constexpr T &operator[](std::size_t i) const { return data_[i]; }

  private:
    static constexpr T *first(std::initializer_list<std::remove_const_t<T>> of) noexcept { return of.begin(); }
    T *data_ = nullptr;
    std::size_t size_ = 0;
};

using Numbers = Span<const double>;

namespace detail {
// An object of C, which is freed with it.
template <class T, void (*Free)(T *)> class Handle {
  public:
    using c_type = T;
    explicit Handle(T *taken) noexcept : own_(taken) {} // takes the C object over
    [[nodiscard]] const T *get() const noexcept { return own_.get(); }
    [[nodiscard]] T *get() noexcept { return own_.get(); }
    [[nodiscard]] T *release() noexcept { return own_.release(); }

  private:
    struct Freeing {
        void operator()(T *object) const noexcept { Free(object); }
    };
    std::unique_ptr<T, Freeing> own_;
};

// A struct of C that owns what is in it.
template <class T, void (*End)(T *)> class Owned {
  public:
    explicit Owned(const T &taken) : own_(new T(taken)) {}
    [[nodiscard]] const T &operator*() const noexcept { return *own_; }
    [[nodiscard]] const T *operator->() const noexcept { return own_.get(); }
    [[nodiscard]] T *get() noexcept { return own_.get(); }

  private:
    struct Ending {
        void operator()(T *object) const noexcept {
            End(object);
            delete object;
        }
    };
    std::unique_ptr<T, Ending> own_;
};

struct FreeBlock {
    void operator()(void *block) const noexcept { bat_free(block); }
};
using Block = std::unique_ptr<void, FreeBlock>;

inline void check(bat_status status) {
    if (status != BAT_OK) throw Error(status);
}
inline void check(bat_status status, const bat_problem &problem) {
    if (status == BAT_OK) return;
    const std::string place = problem.place, message = problem.message;
    if (message.empty()) throw Error(status);
    throw Error(status, place.empty() ? message : place + ": " + message);
}
// A number that a call was given, and its range: from low, or above it, to high.
struct Range {
    const char *name;
    double value, low, high;
    bool above = false;
};
inline void check(bat_status status, std::initializer_list<Range> given) {
    if (status == BAT_OK) return;
    const bool numbers = status == BAT_ARGUMENT || status == BAT_NUMBER || status == BAT_PARAMETER || status == BAT_COUNT || status == BAT_DEGREE;
    for (const Range &one : given) {
        if (!numbers || (one.value >= one.low && one.value <= one.high && !(one.above && one.value == one.low))) continue;
        char text[200];
        if (one.above && one.value <= one.low)
            std::snprintf(text, sizeof text, "%s: expected more than %g, found %g", one.name, one.low, one.value);
        else
            std::snprintf(text, sizeof text, "%s: expected %g to %g, found %g", one.name, one.low, one.high, one.value);
        throw Error(status, text);
    }
    throw Error(status);
}
inline void check(bat_status status, std::size_t wrong) {
    if (status == BAT_OK) return;
    if (wrong == std::numeric_limits<std::size_t>::max()) throw Error(status);
    throw Error(status, bat_status_message(status) + (" (number " + std::to_string(wrong) + ")"));
}
// True: the tolerance was met; false: what was handed over is the best that was found.
inline bool met(bat_status status, bool is_there) {
    if (status != BAT_OK && !(status == BAT_TOLERANCE && is_there)) throw Error(status);
    return status == BAT_OK;
}
inline std::size_t many(const char *name, std::size_t size, std::size_t each) {
    if (each == 0 || size % each != 0)
        throw Error(BAT_COUNT, std::string(name) + ": expected records of " + std::to_string(each) + " numbers, found " + std::to_string(size));
    return size / each;
}
inline void exactly(const char *name, std::size_t size, std::size_t expected) {
    if (size != expected)
        throw Error(BAT_COUNT, std::string(name) + ": expected " + std::to_string(expected) + " numbers, found " + std::to_string(size));
}
inline void inside(const char *name, int value, int low, int high) {
    if (value < low || value > high)
        throw Error(BAT_ARGUMENT, std::string(name) + ": expected a whole number from " + std::to_string(low) + " to " +
                                      std::to_string(high) + ", found " + std::to_string(value));
}
template <class T> std::vector<T> copied(const T *from, std::size_t count) {
    return from == nullptr ? std::vector<T>() : std::vector<T>(from, from + count);
}
template <class T> std::vector<T> taken(T *from, std::size_t count) {
    const Block owner(from);
    return copied(from, count);
}
inline std::string taken_text(char *from, std::size_t size) {
    const Block owner(from);
    return {from, size};
}
template <class H> std::vector<H> taken_objects(typename H::c_type **from, std::size_t count) {
    const Block owner(from);
    std::vector<H> out;
    out.reserve(count);
    for (std::size_t i = 0; i < count; i++) out.emplace_back(from[i]);
    return out;
}
template <class H> typename H::c_type *copy_of(const typename H::c_type *of, bat_status (*copy)(const typename H::c_type *, typename H::c_type **)) {
    typename H::c_type *out = nullptr;
    check(copy(of, &out));
    return out;
}
} // namespace detail

// Objects that a call looks at: of a vector of them, or {a, b, c}.
template <class H> class List {
    struct One {
        One(const H &of) : at(of.get()) {}
        const typename H::c_type *at;
    };

  public:
    List() = default;
    List(const std::vector<H> &of) {
        for (const H &one : of) own_.push_back(one.get());
    }
    List(std::initializer_list<One> of) {
        for (const One &one : of) own_.push_back(one.at);
    }
    [[nodiscard]] const typename H::c_type *const *data() const noexcept { return own_.data(); }
    [[nodiscard]] std::size_t size() const noexcept { return own_.size(); }
    // Copies for a call that keeps them, whatever it returns.
    template <class Copy> [[nodiscard]] std::vector<typename H::c_type *> kept(Copy copy) const {
        std::vector<H> copies;
        for (const auto *one : own_) copies.emplace_back(detail::copy_of<H>(one, copy));
        std::vector<typename H::c_type *> out;
        for (H &one : copies) out.push_back(one.release());
        return out;
    }

  private:
    std::vector<const typename H::c_type *> own_;
};

// A stroke of the pen: its points, and pressure and time where they are known (empty: not).
struct Stroke {
    Numbers points;
    int dimension = 2;
    Numbers pressure{}, time{};

    operator bat_stroke() const {
        const std::size_t count = detail::many("points", points.size(), static_cast<std::size_t>(dimension));
        if (!pressure.empty()) detail::exactly("pressure", pressure.size(), count);
        if (!time.empty()) detail::exactly("time", time.size(), count);
        return {dimension, count, points.data(), pressure.empty() ? nullptr : pressure.data(), time.empty() ? nullptr : time.data()};
    }
};

class Curve;
class Finder;
class Chain;
class Shape;
class LiveShape;
class LiveSketch;
class Surface;
class SurfaceFinder;
class Tessellation;
class Relief;
class Sweep;
class Mesh;
class Reference;
class Binding;
class Tracks;
class LineDrawing;
class Camera;
class Take;
class Motion;
class Picture;
class Object;
class Document;
struct CurveBasisResult;
struct CurveRemoveKnotResult;
struct CurveSimplifyResult;
struct CurveSplitResult;
struct CurveJoinResult;
struct CurveToBezierResult;
struct FromBezierResult;
struct CurveBoundsResult;
struct CurveDistanceResult;
struct CurveFlattenResult;
struct CurveArcsResult;
struct CurveOffsetResult;
struct FitResult;
struct CurveRefitResult;
struct CurveRefitG1Result;
struct CurveRefitExtremesResult;
struct FitWithinResult;
struct CurveFramesAtResult;
struct CurveSketchResult;
struct SketchResult;
struct CurveSmoothResult;
struct CurveSketchJoinResult;
struct LivesketchPreviewResult;
struct LivesketchCommitResult;
struct SplineResult;
struct ShapeRedrawResult;
struct LiveshapeTouchedResult;
struct CurveBlendResult;
struct CurveMatchResult;
struct CurveOutlineResult;
struct CurveOutlineWidthResult;
struct SurfaceBoxResult;
struct SurfaceNormalGridResult;
struct SurfaceCurvatureResult;
struct SurfaceRedrawResult;
struct SurfaceTessellateResult;
struct SweepSurfaceResult;
struct CurveRevolveResult;
struct CoonsResult;
struct SurfaceMatchResult;
struct LoftResult;
struct RecipeSurfaceResult;
struct MeshBoxResult;
struct ReferenceNearestResult;
struct BindingApplyResult;
struct ViewRayResult;
struct ViewProjectResult;
struct CastResult;
struct SurfaceSketchResult;
struct TakeMotionResult;

class Curve : public detail::Handle<bat_curve, bat_curve_free> {
  public:
    using Handle::Handle;
    [[nodiscard]] Curve copy() const;
    [[nodiscard]] int degree() const;
    [[nodiscard]] int dimension() const;
    [[nodiscard]] bool closed() const;
    [[nodiscard]] size_t count() const;
    [[nodiscard]] int knot_count() const;
    [[nodiscard]] Span<const double> knots() const;
    [[nodiscard]] Span<const double> points() const;
    [[nodiscard]] std::array<double, 2> domain() const;
    [[nodiscard]] double size() const;
    [[nodiscard]] bool is_equal(const Curve &b) const;
    [[nodiscard]] std::vector<double> at(double u, int order = 0) const;
    [[nodiscard]] std::vector<double> at_left(double u, int order = 0) const;
    [[nodiscard]] std::vector<double> at_many(Numbers u, int order = 0) const;
    [[nodiscard]] std::vector<double> spread(size_t count) const;
    [[nodiscard]] std::vector<double> blossom(double u, Numbers arguments, bool left = false) const;
    [[nodiscard]] std::vector<double> greville() const;
    [[nodiscard]] CurveBasisResult basis(double u) const;
    [[nodiscard]] Curve transform(Numbers matrix) const;
    [[nodiscard]] Curve to_dimension(int dimension) const;
    [[nodiscard]] Curve insert_knot(double u, int times = 1) const;
    [[nodiscard]] Curve insert_knots(Numbers knots) const;
    [[nodiscard]] Curve refine(Numbers knots) const;
    [[nodiscard]] CurveRemoveKnotResult remove_knot(double u, int times = 1, double tolerance = 0) const;
    [[nodiscard]] CurveSimplifyResult simplify(double tolerance, double corner = 0.05) const;
    [[nodiscard]] Curve elevate(int degree) const;
    [[nodiscard]] Curve clamp() const;
    [[nodiscard]] Curve reverse() const;
    [[nodiscard]] Curve reparametrise(double start, double end) const;
    [[nodiscard]] CurveSplitResult split(double u) const;
    [[nodiscard]] Curve piece(double start, double end) const;
    [[nodiscard]] Curve open_at(double u) const;
    [[nodiscard]] Curve close(double tolerance = 1e-9) const;
    [[nodiscard]] Curve move_seam(double u) const;
    [[nodiscard]] CurveJoinResult join(const Curve &b, int continuity = 0, double gap = 1e-9) const;
    [[nodiscard]] int segment_count() const;
    [[nodiscard]] CurveToBezierResult to_bezier() const;
    [[nodiscard]] std::vector<double> to_cubics(double tolerance = 0.01) const;
    [[nodiscard]] Curve drag(Numbers u, Numbers delta) const;
    [[nodiscard]] Curve move_point(int index, Numbers delta) const;
    [[nodiscard]] double length(std::optional<double> u0 = {}, std::optional<double> u1 = {}, double relative = 1e-12) const;
    [[nodiscard]] double at_length(double s, std::optional<double> u0 = {}, double relative = 1e-12) const;
    [[nodiscard]] CurveBoundsResult bounds() const;
    [[nodiscard]] double area() const;
    [[nodiscard]] double curvature(double u) const;
    [[nodiscard]] std::vector<double> inflections() const;
    [[nodiscard]] std::vector<double> extremes(int axis) const;
    [[nodiscard]] CurveDistanceResult distance(const Curve &b, int per_span = 16) const;
    [[nodiscard]] bat_near nearest(Numbers point) const;
    [[nodiscard]] std::vector<bat_near> nearest_all(Numbers point, double within = std::numeric_limits<double>::infinity()) const;
    [[nodiscard]] double project_near(Numbers point, double u, int steps = 8) const;
    [[nodiscard]] Finder finder() const;
    [[nodiscard]] bat_apart hausdorff(const Curve &b, double precision) const;
    [[nodiscard]] detail::Owned<bat_meeting, bat_meeting_free> intersect(const Curve &b, double tolerance) const;
    [[nodiscard]] detail::Owned<bat_meeting, bat_meeting_free> self_intersect(double tolerance) const;
    [[nodiscard]] CurveFlattenResult flatten(double tolerance) const;
    [[nodiscard]] CurveArcsResult arcs(double tolerance, double corner = 0.05) const;
    [[nodiscard]] CurveOffsetResult offset(double distance, double tolerance, double corner = 0.05) const;
    [[nodiscard]] CurveRefitResult refit(double tolerance, double corner = 0.05) const;
    [[nodiscard]] CurveRefitG1Result refit_g1(double tolerance, double corner = 0.05) const;
    [[nodiscard]] CurveRefitExtremesResult refit_extremes(double tolerance, double corner = 0.05, double grid = 0) const;
    [[nodiscard]] CurveFramesAtResult frames_at(Numbers u, const bat_frame_options *options = nullptr) const;
    [[nodiscard]] Chain frame_chain(const bat_frame_options *options = nullptr) const;
    [[nodiscard]] CurveSketchResult sketch(const bat_stroke &stroke, const bat_sketch_options *options = nullptr) const;
    [[nodiscard]] CurveSmoothResult smooth(const bat_stroke &stroke, const bat_sketch_options *options = nullptr) const;
    [[nodiscard]] Curve calm(Numbers range, double limit, double pixel = 1) const;
    [[nodiscard]] CurveSketchJoinResult sketch_join(const Curve &b, const bat_stroke &stroke, const bat_sketch_options *options = nullptr) const;
    [[nodiscard]] LiveSketch live(const bat_sketch_options *options = nullptr, bat_sketch_kind kind = static_cast<bat_sketch_kind>(0)) const;
    [[nodiscard]] Shape shape(const bat_shape_options *options = nullptr) const;
    [[nodiscard]] Shape levels(int levels, const bat_shape_options *options = nullptr) const;
    [[nodiscard]] Shape levels_to(int levels, size_t coarsest, const bat_shape_options *options = nullptr) const;
    [[nodiscard]] CurveBlendResult blend(const Curve &b, const bat_blend_options *options = nullptr, bool a_end = true, bool b_end = false) const;
    [[nodiscard]] CurveMatchResult match(const Curve &b, bool a_end = true, bool b_end = false, int continuity = 2, double tension = 1.0) const;
    [[nodiscard]] std::array<double, 4> jump(const Curve &b, bool a_end = true, bool b_end = false) const;
    [[nodiscard]] CurveOutlineResult outline(const bat_nib &nib, double tolerance, double corner = 0.05) const;
    [[nodiscard]] CurveOutlineWidthResult outline_width(const bat_nib &nib, const bat_width_profile &profile, double tolerance, double corner = 0.05) const;
    [[nodiscard]] std::vector<double> cover_width(const bat_nib &nib, const bat_width_profile &profile, double tolerance, double corner = 0.05) const;
    [[nodiscard]] Sweep sweep(const Curve &profile, const bat_sweep_options *options = nullptr) const;
    [[nodiscard]] CurveRevolveResult revolve(Numbers origin, Numbers direction, double tolerance, double angle = 6.283185307179586) const;
    [[nodiscard]] bat_recipe_stand stands(const Curve &profile) const;
    [[nodiscard]] bat_deviation deviation(const Reference &reference, double spacing = 0.0) const;
    [[nodiscard]] Camera camera(const bat_camera_options *options = nullptr) const;
    [[nodiscard]] std::string write() const;
};

class Finder : public detail::Handle<bat_finder, bat_finder_free> {
  public:
    using Handle::Handle;
    [[nodiscard]] bat_near nearest(Numbers point) const;

  public:
    Finder(bat_finder *taken, int dimension) noexcept : Handle(taken), dimension_(dimension) {}

  private:
    int dimension_ = 2;
};

class Chain : public detail::Handle<bat_frame_chain, bat_frame_chain_free> {
  public:
    using Handle::Handle;
    [[nodiscard]] bat_frame3 at(double u) const;
    [[nodiscard]] double holonomy() const;
    [[nodiscard]] bat_frame_options follow() const;
};

class Shape : public detail::Handle<bat_shape, bat_shape_free> {
  public:
    using Handle::Handle;
    [[nodiscard]] Shape copy() const;
    void add_level(Numbers knots = {});
    [[nodiscard]] int levels() const;
    [[nodiscard]] std::optional<Curve> curve(int level) const;
    [[nodiscard]] Curve flatten() const;
    [[nodiscard]] Span<const double> details(int level) const;
    [[nodiscard]] Span<const double> nodes(int level) const;
    [[nodiscard]] Span<const int> source(int level) const;
    [[nodiscard]] double gain(int level) const;
    [[nodiscard]] bool is_muted(int level) const;
    [[nodiscard]] const bat_shape_options *options() const;
    void move(int level, int index, Numbers delta);
    void drag(int level, double u, Numbers delta);
    [[nodiscard]] double drag_finest(int level, double u, Numbers delta, double tolerance);
    void move_many(int level, int first, Numbers deltas);
    void set_gain(int level, double gain);
    void set_muted(int level, bool muted);
    void sketch(int level, Numbers u, Numbers targets);
    [[nodiscard]] bat_sketch_report redraw_level(int level, const bat_stroke &stroke, const bat_sketch_options *options = nullptr);
    [[nodiscard]] ShapeRedrawResult redraw(const bat_stroke &stroke, const bat_sketch_options *options = nullptr, bool drop = false) const;
    void transform(Numbers matrix);
    void reframe(Numbers matrix = {}, bat_frame_rule rule = static_cast<bat_frame_rule>(0));
    [[nodiscard]] Shape to_dimension(int dimension) const;
    void commit();
    [[nodiscard]] LiveShape live(int level) const;
    [[nodiscard]] Shape copy_levels(const Curve &onto) const;
    [[nodiscard]] std::string write() const;
    void edit(std::string_view text);
};

class LiveShape : public detail::Handle<bat_shape_live, bat_shape_live_cancel> {
  public:
    using Handle::Handle;
    void move(int first, Numbers deltas);
    void drag(double u, Numbers delta);
    [[nodiscard]] double drag_finest(double u, Numbers delta, double tolerance);
    [[nodiscard]] std::optional<Shape> shape() const;
    [[nodiscard]] LiveshapeTouchedResult touched(int level) const;
    [[nodiscard]] Shape commit();
};

class LiveSketch : public detail::Handle<bat_sketch_live, bat_sketch_live_cancel> {
  public:
    using Handle::Handle;
    void add_many(const bat_stroke &samples);
    [[nodiscard]] LivesketchPreviewResult preview();
    [[nodiscard]] LivesketchCommitResult commit();
};

class Surface : public detail::Handle<bat_surface, bat_surface_free> {
  public:
    using Handle::Handle;
    [[nodiscard]] Surface copy() const;
    [[nodiscard]] int degree(bat_direction direction) const;
    [[nodiscard]] bool is_closed(bat_direction direction) const;
    [[nodiscard]] size_t count(bat_direction direction) const;
    [[nodiscard]] int knot_count(bat_direction direction) const;
    [[nodiscard]] Span<const double> knots(bat_direction direction) const;
    [[nodiscard]] std::array<double, 2> domain(bat_direction direction) const;
    [[nodiscard]] SurfaceBoxResult box() const;
    [[nodiscard]] double size() const;
    [[nodiscard]] bool is_equal(const Surface &b) const;
    [[nodiscard]] Surface transform(Numbers matrix) const;
    [[nodiscard]] std::vector<double> at(double u, double v, int order = 0) const;
    [[nodiscard]] std::vector<double> at_grid(Numbers u, Numbers v, int order = 0) const;
    [[nodiscard]] SurfaceNormalGridResult normal_grid(Numbers u, Numbers v) const;
    [[nodiscard]] std::vector<double> spread(bat_direction direction, size_t count) const;
    [[nodiscard]] std::array<double, 3> normal(double u, double v) const;
    [[nodiscard]] SurfaceCurvatureResult curvature(double u, double v) const;
    [[nodiscard]] Curve isocurve(bat_direction direction, double at) const;
    [[nodiscard]] bat_surface_point nearest(Numbers point) const;
    [[nodiscard]] std::vector<bat_surface_point> hits(Numbers origin, Numbers direction) const;
    [[nodiscard]] SurfaceFinder finder() const;
    [[nodiscard]] Surface insert_knots(bat_direction direction, Numbers knots) const;
    [[nodiscard]] Surface refine(bat_direction direction, Numbers knots) const;
    [[nodiscard]] SurfaceRedrawResult redraw(bat_direction direction, double at, const Curve &line, const bat_surface_redraw_options *options = nullptr) const;
    [[nodiscard]] SurfaceTessellateResult tessellate(const bat_tessellate_options *options = nullptr) const;
    [[nodiscard]] Relief relief() const;
    [[nodiscard]] Relief levels(int levels) const;
    [[nodiscard]] Relief levels_to(int levels, Span<const size_t> coarsest) const;
    [[nodiscard]] Surface blend(bat_side side, const Surface &other, bat_side other_side, const bat_blend_options *options = nullptr) const;
    [[nodiscard]] Surface blend_to_curve(bat_side side, const Curve &curve, const bat_blend_options *options = nullptr) const;
    [[nodiscard]] SurfaceMatchResult match(bat_side side, const Surface &other, bat_side other_side, int continuity = 2, double tension = 1.0) const;
    [[nodiscard]] bat_deviation deviation(const Reference &reference, double spacing = 0.0) const;
    [[nodiscard]] Tracks silhouettes(const bat_viewpoint &view) const;
    [[nodiscard]] Tracks section(Numbers origin, Numbers normal, double tolerance = 0.0) const;
    [[nodiscard]] Tracks intersect(const Surface &b, const bat_intersect_options *options = nullptr) const;
    [[nodiscard]] bat_surface_pick pick_line(const bat_viewpoint &view, const bat_stroke &marking) const;
    [[nodiscard]] SurfaceSketchResult sketch(bat_direction direction, double at, const bat_viewpoint &view, const bat_stroke &stroke, const bat_surface_sketch_options *options = nullptr) const;
    [[nodiscard]] std::string write() const;

    // The control points, row by row.
    [[nodiscard]] std::vector<double> points() const {
        std::vector<double> out;
        for (std::size_t i = 0; i < count(BAT_U); i++) {
            const double *row = bat_surface_row(get(), static_cast<int>(i));
            out.insert(out.end(), row, row + 3 * count(BAT_V));
        }
        return out;
    }
};

class SurfaceFinder : public detail::Handle<bat_surface_finder, bat_surface_finder_free> {
  public:
    using Handle::Handle;
    [[nodiscard]] bat_surface_point nearest(Numbers point) const;
    [[nodiscard]] std::vector<bat_surface_point> hits(Numbers origin, Numbers direction) const;
};

class Tessellation : public detail::Handle<bat_tessellation, bat_tessellation_free> {
  public:
    using Handle::Handle;
    [[nodiscard]] std::array<size_t, 2> update(const Surface &surface, bat_direction direction, Numbers moved);
};

class Relief : public detail::Handle<bat_relief, bat_relief_free> {
  public:
    using Handle::Handle;
    [[nodiscard]] Relief copy() const;
    void add_level(Span<const int> knot_count, Numbers u_knots = {}, Numbers v_knots = {}, Numbers details = {}, Span<const int> source = {});
    [[nodiscard]] int levels() const;
    [[nodiscard]] std::optional<Surface> surface(int level) const;
    [[nodiscard]] Span<const double> details(int level) const;
    [[nodiscard]] Span<const int> source(int level) const;
    [[nodiscard]] double gain(int level) const;
    [[nodiscard]] bool is_muted(int level) const;
    void move(int level, Span<const size_t> index, Numbers deltas);
    void drag(int level, double u, double v, Numbers delta);
    [[nodiscard]] double drag_finest(int level, double u, double v, Numbers delta, double tolerance);
    [[nodiscard]] bat_surface_redraw_report redraw(int level, bat_direction direction, double at, const Curve &line, const bat_surface_redraw_options *options = nullptr);
    void set_gain(int level, double gain);
    void set_muted(int level, bool muted);
    void transform(Numbers matrix);
    [[nodiscard]] Relief copy_levels(const Surface &onto) const;
    [[nodiscard]] std::string write() const;
};

class Sweep : public detail::Handle<bat_sweep, bat_sweep_free> {
  public:
    using Handle::Handle;
    [[nodiscard]] std::array<double, 2> domain(bat_direction direction) const;
    [[nodiscard]] double holonomy() const;
    [[nodiscard]] bat_sweep_point at(double u, double v) const;
    [[nodiscard]] std::vector<double> folds() const;
    [[nodiscard]] SweepSurfaceResult surface(double tolerance) const;
};

class Mesh : public detail::Handle<bat_polymesh, bat_polymesh_free> {
  public:
    using Handle::Handle;
    [[nodiscard]] Mesh copy() const;
    [[nodiscard]] size_t vertex_count() const;
    [[nodiscard]] Span<const double> vertices() const;
    [[nodiscard]] size_t face_count() const;
    [[nodiscard]] Span<const int> face(size_t i) const;
    [[nodiscard]] MeshBoxResult box() const;
    [[nodiscard]] double size() const;
    [[nodiscard]] bool is_equal(const Mesh &b) const;
    [[nodiscard]] Mesh with_vertices(Numbers vertices) const;
    [[nodiscard]] size_t triangle_count() const;
    [[nodiscard]] std::vector<int> triangles() const;
    [[nodiscard]] std::vector<double> normals() const;
    [[nodiscard]] bat_deviation deviation(const Reference &reference, double spacing = 0.0) const;
    [[nodiscard]] std::string write() const;
};

class Reference : public detail::Handle<bat_reference, bat_reference_free> {
  public:
    using Handle::Handle;
    [[nodiscard]] ReferenceNearestResult nearest(Numbers point) const;
};

class Binding : public detail::Handle<bat_binding, bat_binding_free> {
  public:
    using Handle::Handle;
    [[nodiscard]] size_t count() const;
    [[nodiscard]] BindingApplyResult apply(const List<Curve> &curves, Numbers points) const;
    [[nodiscard]] std::vector<int> torn(Span<const int> edges) const;
};

class Tracks : public detail::Handle<bat_tracks, bat_tracks_free> {
  public:
    using Handle::Handle;
    [[nodiscard]] size_t count() const;
    [[nodiscard]] bool is_closed(size_t i) const;
    [[nodiscard]] size_t crossing_count() const;
    [[nodiscard]] const bat_track_point *crossing(size_t i) const;
    [[nodiscard]] bool is_given_up() const;
    [[nodiscard]] Curve curve(size_t i, double tolerance) const;
};

class LineDrawing : public detail::Handle<bat_line_drawing, bat_line_drawing_free> {
  public:
    using Handle::Handle;
    [[nodiscard]] size_t count() const;
    [[nodiscard]] bool is_whole() const;
};

class Camera : public detail::Handle<bat_camera, bat_camera_free> {
  public:
    using Handle::Handle;
    [[nodiscard]] Camera copy() const;
    [[nodiscard]] Camera with_path(const Curve &path) const;
    void add_level(Numbers knots, Numbers details);
    [[nodiscard]] int levels() const;
    [[nodiscard]] std::optional<Curve> details(int level) const;
    [[nodiscard]] double gain(int level) const;
    void set_gain(int level, double gain);
    void set_muted(int level, bool muted);
    [[nodiscard]] bool is_muted(int level) const;
    void add_shake(uint64_t seed, double amount, double rate);
    [[nodiscard]] bat_camera_shake shake(int level) const;
    void take_levels(const Camera &other);
    [[nodiscard]] const bat_function *timing() const;
    void set_timing(double duration, const bat_function *timing = nullptr);
    void retime(Numbers points);
    void ease(double begin = 0.0, double end = 0.0);
    void turn(int level, double u, Numbers rotation);
    void turn_base(Numbers rotation);
    [[nodiscard]] Span<const double> base() const;
    [[nodiscard]] double key_place(size_t key) const;
    [[nodiscard]] size_t add_key(double u);
    [[nodiscard]] double remove_key(size_t key);
    void set_fov(double u, double degrees);
    [[nodiscard]] Camera aim(Numbers target, Numbers up) const;
    [[nodiscard]] Camera let_go(Numbers first = {}) const;
    [[nodiscard]] bat_camera_mode mode() const;
    [[nodiscard]] std::optional<Curve> path() const;
    [[nodiscard]] std::array<double, 2> domain() const;
    [[nodiscard]] double length() const;
    [[nodiscard]] double duration() const;
    [[nodiscard]] double least_norm() const;
    [[nodiscard]] std::vector<double> held() const;
    [[nodiscard]] bat_camera_pose at(double u) const;
    [[nodiscard]] bat_camera_pose at_time(double time) const;
    [[nodiscard]] std::vector<bat_camera_pose> sample(Numbers times) const;
    [[nodiscard]] std::vector<bat_camera_key> keys(double place, double angle) const;
    [[nodiscard]] std::string to_gltf(double place = 0.0, double angle = 0.0) const;
    [[nodiscard]] std::string to_gltf_scene(const bat_model &scene, double place = 0.0, double angle = 0.0) const;
    [[nodiscard]] std::string write() const;
};

class Take : public detail::Handle<bat_take, bat_take_free> {
  public:
    using Handle::Handle;
    [[nodiscard]] Span<const bat_bone> joints() const;
    [[nodiscard]] Span<const double> values() const;
    [[nodiscard]] double frame_time() const;
    [[nodiscard]] std::vector<double> positions(size_t frame) const;
    [[nodiscard]] TakeMotionResult motion(const bat_motion_options *options = nullptr) const;
    [[nodiscard]] std::string to_bvh() const;
};

class Motion : public detail::Handle<bat_motion, bat_motion_free> {
  public:
    using Handle::Handle;
    [[nodiscard]] Motion copy() const;
    [[nodiscard]] double duration() const;
    [[nodiscard]] std::vector<double> positions(double time) const;
    [[nodiscard]] int levels() const;
    [[nodiscard]] std::optional<Camera> joint(int joint) const;
    [[nodiscard]] std::optional<Shape> path() const;
    void set_gain(int joint, int level, double gain);
    [[nodiscard]] double angle(int joint, int angle, double time) const;
    void redraw(int joint, int angle, int level, Numbers points);
    void bend(const Curve &path);
    void take_style(const Motion &other);
    [[nodiscard]] Take sample() const;
    [[nodiscard]] std::string write(const bat_motion_report &report) const;

  private:
    [[nodiscard]] std::size_t joints() const {
        int count = 0;
        bat_take_joints(bat_motion_take(get()), &count);
        return static_cast<std::size_t>(count);
    }
};

class Picture : public detail::Handle<bat_picture, bat_picture_release> {
  public:
    using Handle::Handle;
    [[nodiscard]] const char *type() const;
    [[nodiscard]] uint64_t digest() const;
    [[nodiscard]] std::array<double, 2> sides() const;
};

class Object : public detail::Handle<bat_object, bat_object_release> {
  public:
    using Handle::Handle;
    [[nodiscard]] Object with_matrix(Numbers matrix) const;
    [[nodiscard]] bool is_foreign() const;
    [[nodiscard]] Object with_guide(double at) const;
    [[nodiscard]] Object with_recipe(const bat_recipe &recipe, const List<Object> &sources) const;
    [[nodiscard]] Object with_surface(const Surface &surface) const;
    [[nodiscard]] Object bind(Span<const bat_wire> wires, const List<Object> &curves, const bat_wire_options *options = nullptr) const;
    [[nodiscard]] Object unbind(bool revert = false) const;
    [[nodiscard]] Object with_relief(const Relief &relief) const;
    [[nodiscard]] Object with_camera(const Camera &camera, bat_id follows = 0) const;
    [[nodiscard]] Object with_motion(const Motion &motion) const;
    [[nodiscard]] Object at_time(double seconds) const;
    [[nodiscard]] Object with_curves(const List<Curve> &curves) const;
    [[nodiscard]] Object with_parent(bat_id parent) const;
    [[nodiscard]] Object with_name(const std::string &name) const;
    [[nodiscard]] Object with_state(bool hidden = false, bool locked = false) const;
    [[nodiscard]] Object with_id(bat_id id) const;
    [[nodiscard]] Object with_curve(int index, const Curve &curve) const;
    [[nodiscard]] Object with_style(const bat_style &style) const;
    [[nodiscard]] Object with_shape(int index, const Shape &shape) const;
    [[nodiscard]] Object with_spline(const bat_spline &spline) const;
    [[nodiscard]] Object to_path() const;
    [[nodiscard]] bat_id id() const;
    [[nodiscard]] bat_kind kind() const;
    [[nodiscard]] const char *name() const;
    [[nodiscard]] const bat_style *style() const;
    [[nodiscard]] int curve_count() const;
    [[nodiscard]] bool is_made_of_curves() const;
    [[nodiscard]] std::optional<Curve> curve(int index) const;
    [[nodiscard]] const bat_tangents_options *spline_options() const;
    [[nodiscard]] std::optional<Shape> shape(int index) const;
    [[nodiscard]] std::optional<Picture> picture() const;
    [[nodiscard]] Span<const double> matrix() const;
    [[nodiscard]] bool is_group() const;
    [[nodiscard]] bool is_drawn() const;
    [[nodiscard]] std::optional<Surface> surface() const;
    [[nodiscard]] std::optional<Mesh> mesh() const;
    [[nodiscard]] std::optional<Relief> relief() const;
    [[nodiscard]] const bat_recipe *recipe() const;
    [[nodiscard]] std::optional<Camera> camera() const;
    [[nodiscard]] std::optional<Motion> motion() const;
    [[nodiscard]] bat_id followed() const;
    [[nodiscard]] Span<const double> plane() const;
    [[nodiscard]] const bat_viewpoint *view() const;
    [[nodiscard]] bat_id parent() const;
    [[nodiscard]] bool is_hidden() const;
    [[nodiscard]] bool is_locked() const;
    [[nodiscard]] std::array<double, 4> bounds() const;
    [[nodiscard]] Object with_paint(const bat_paint &paint) const;
    [[nodiscard]] const bat_paint *paint() const;
    [[nodiscard]] std::vector<double> cover(int curve) const;
};

class Document : public detail::Handle<bat_document, bat_document_free> {
  public:
    using Handle::Handle;
    [[nodiscard]] Document copy() const;
    [[nodiscard]] int count() const;
    [[nodiscard]] std::optional<Object> at(int index) const;
    [[nodiscard]] int find(bat_id id) const;
    [[nodiscard]] bat_id new_id();
    void insert(int index, const Object &object);
    void replace(int index, const Object &object);
    void remove(int index);
    [[nodiscard]] int end(int index) const;
    [[nodiscard]] std::array<double, 4> page() const;
    void set_page(Numbers page);
    [[nodiscard]] std::array<double, 4> bounds() const;
    [[nodiscard]] double scale() const;
    [[nodiscard]] bat_unit unit() const;
    void set_scale(double millimetres, bat_unit unit);
    [[nodiscard]] const char *check() const;
    [[nodiscard]] uint64_t digest() const;
    [[nodiscard]] std::string write() const;
    [[nodiscard]] std::string to_dxf(double arcs = 0.0) const;
    [[nodiscard]] std::string to_glif(bool extremes = false) const;
    [[nodiscard]] std::string replace_glif(std::string_view glyph, bool extremes = false) const;
    [[nodiscard]] std::string to_gcode(const bat_gcode_options *options = nullptr) const;
    [[nodiscard]] std::string to_svg(bool native = true) const;
    [[nodiscard]] std::string to_svg_within(double precision, bool native = true) const;
    [[nodiscard]] std::string to_svg_kept(bool native = true, double precision = -1) const;
    [[nodiscard]] bool is_kept() const;
};

struct CurveBasisResult {
    int first;
    std::vector<double> values;
};

struct CurveRemoveKnotResult {
    Curve out;
    int removed;
    double error;
};

struct CurveSimplifyResult {
    Curve out;
    double error;
};

struct CurveSplitResult {
    Curve left;
    Curve right;
};

struct CurveJoinResult {
    Curve out;
    double moved;
};

struct CurveToBezierResult {
    std::vector<double> points;
    std::vector<double> breaks;
};

struct FromBezierResult {
    Curve out;
    double error;
};

struct CurveBoundsResult {
    std::vector<double> low;
    std::vector<double> high;
};

struct CurveDistanceResult {
    double a_to_b;
    double b_to_a;
};

struct CurveFlattenResult {
    std::vector<double> points;
    std::vector<double> u;
};

struct CurveArcsResult {
    std::vector<bat_arc> arcs;
    double max_error;
};

struct CurveOffsetResult {
    std::vector<Curve> curves;
    double max_error;
    bool within;
};

struct FitResult {
    Curve out;
    bat_fit_report report;
    bool within;
};

struct CurveRefitResult {
    Curve out;
    double error;
};

struct CurveRefitG1Result {
    Curve out;
    double error;
};

struct CurveRefitExtremesResult {
    Curve out;
    double error;
};

struct FitWithinResult {
    Curve out;
    bat_fit_report report;
};

struct CurveFramesAtResult {
    std::vector<bat_frame3> frames;
    double holonomy;
};

struct CurveSketchResult {
    Curve out;
    bat_sketch_report report;
    bool within;
};

struct SketchResult {
    Curve out;
    bat_sketch_report report;
};

struct CurveSmoothResult {
    Curve out;
    bat_sketch_report report;
};

struct CurveSketchJoinResult {
    Curve out;
    bat_sketch_report report;
};

struct LivesketchPreviewResult {
    Curve out;
    bat_sketch_live_info info;
};

struct LivesketchCommitResult {
    Curve out;
    bat_sketch_report report;
};

struct SplineResult {
    std::vector<bat_joint> joints;
    std::vector<double> bezier;
    Curve out;
};

struct ShapeRedrawResult {
    Shape out;
    bat_sketch_report report;
    bool within;
};

struct LiveshapeTouchedResult {
    int first;
    size_t points;
};

struct CurveBlendResult {
    Curve out;
    double variation;
};

struct CurveMatchResult {
    Curve out;
    double moved;
};

struct CurveOutlineResult {
    std::vector<Curve> curves;
    double max_error;
    bool within;
};

struct CurveOutlineWidthResult {
    std::vector<Curve> curves;
    double max_error;
};

struct SurfaceBoxResult {
    std::array<double, 3> low;
    std::array<double, 3> high;
};

struct SurfaceNormalGridResult {
    std::vector<double> points;
    std::vector<double> normals;
};

struct SurfaceCurvatureResult {
    double gauss;
    double mean;
};

struct SurfaceRedrawResult {
    Surface out;
    std::vector<double> weights;
    bat_surface_redraw_report report;
};

struct SurfaceTessellateResult {
    Tessellation out;
    bat_tessellate_report report;
};

struct SweepSurfaceResult {
    Surface out;
    bat_sweep_report report;
    bool within;
};

struct CurveRevolveResult {
    Surface out;
    double max_error;
};

struct CoonsResult {
    Surface out;
    std::array<double, 4> apart;
};

struct SurfaceMatchResult {
    Surface out;
    double moved;
};

struct LoftResult {
    Surface out;
    std::vector<double> v;
};

struct RecipeSurfaceResult {
    Surface out;
    bat_recipe_report report;
    bool within;
};

struct MeshBoxResult {
    std::array<double, 3> low;
    std::array<double, 3> high;
};

struct ReferenceNearestResult {
    std::array<double, 3> closest;
    double distance;
};

struct BindingApplyResult {
    std::vector<double> points;
    bat_wire_report report;
};

struct ViewRayResult {
    std::array<double, 3> origin;
    std::array<double, 3> direction;
};

struct ViewProjectResult {
    std::array<double, 2> pixel;
    double depth;
};

struct CastResult {
    std::vector<bat_cast_point> out;
    size_t landed;
};

struct SurfaceSketchResult {
    Surface out;
    std::vector<double> weights;
    bat_surface_sketch_report report;
    bool within;
};

struct TakeMotionResult {
    Motion out;
    bat_motion_report report;
};

inline Curve Curve::copy() const {
    bat_curve *out_ = nullptr;
    const bat_status status = bat_curve_copy(get(), &out_);
    Curve made = Curve(out_);
    detail::check(status);
    return made;
}

inline int Curve::degree() const {
    return bat_curve_degree(get());
}

inline int Curve::dimension() const {
    return bat_curve_dimension(get());
}

inline bool Curve::closed() const {
    return bat_curve_is_closed(get());
}

inline size_t Curve::count() const {
    return bat_curve_count(get());
}

inline int Curve::knot_count() const {
    return bat_curve_knot_count(get());
}

inline Span<const double> Curve::knots() const {
    const double *found = bat_curve_knots(get());
    return Span<const double>(found, found == nullptr ? 0 : static_cast<std::size_t>(knot_count()));
}

inline Span<const double> Curve::points() const {
    const double *found = bat_curve_points(get());
    return Span<const double>(found, found == nullptr ? 0 : static_cast<std::size_t>(count())*static_cast<std::size_t>(dimension()));
}

inline std::array<double, 2> Curve::domain() const {
    std::array<double, 2> domain_{};
    bat_curve_domain(get(), domain_.data());
    return domain_;
}

inline double Curve::size() const {
    return bat_curve_size(get());
}

inline bool Curve::is_equal(const Curve &b) const {
    return bat_curve_is_equal(get(), b.get());
}

inline std::vector<double> Curve::at(double u, int order) const {
    detail::inside("order", order, 0, 7);
    std::vector<double> out_((static_cast<std::size_t>(order)+1)*static_cast<std::size_t>(dimension()));
    bat_curve_eval(get(), u, order, out_.data());
    return out_;
}

inline std::vector<double> Curve::at_left(double u, int order) const {
    detail::inside("order", order, 0, 7);
    std::vector<double> out_((static_cast<std::size_t>(order)+1)*static_cast<std::size_t>(dimension()));
    bat_curve_eval_left(get(), u, order, out_.data());
    return out_;
}

inline std::vector<double> Curve::at_many(Numbers u, int order) const {
    detail::inside("order", order, 0, 7);
    std::vector<double> out_(u.size()*(static_cast<std::size_t>(order)+1)*static_cast<std::size_t>(dimension()));
    const bat_status status = bat_curve_eval_many(get(), u.size(), u.data(), order, out_.data());
    detail::check(status, {{"order", static_cast<double>(order), -1e+75, 1e+75}});
    return out_;
}

inline std::vector<double> Curve::spread(size_t count) const {
    std::vector<double> u_(static_cast<std::size_t>(count));
    bat_curve_spread(get(), count, u_.data());
    return u_;
}

inline std::vector<double> Curve::blossom(double u, Numbers arguments, bool left) const {
    detail::exactly("arguments", arguments.size(), static_cast<std::size_t>(degree()));
    std::vector<double> out_(static_cast<std::size_t>(dimension()));
    bat_curve_blossom(get(), u, arguments.data(), left, out_.data());
    return out_;
}

inline std::vector<double> Curve::greville() const {
    std::vector<double> out_(static_cast<std::size_t>(count()));
    bat_curve_greville(get(), out_.data());
    return out_;
}

inline CurveBasisResult Curve::basis(double u) const {
    int first_{};
    std::vector<double> values_(static_cast<std::size_t>(degree())+1);
    bat_curve_basis(get(), u, &first_, values_.data());
    return {first_, std::move(values_)};
}

inline Curve Curve::transform(Numbers matrix) const {
    detail::exactly("matrix", matrix.size(), static_cast<std::size_t>(dimension())*(static_cast<std::size_t>(dimension())+1));
    bat_curve *out_ = nullptr;
    const bat_status status = bat_curve_transform(get(), matrix.data(), &out_);
    Curve made = Curve(out_);
    detail::check(status);
    return made;
}

inline Curve Curve::to_dimension(int dimension) const {
    detail::inside("dimension", dimension, 2, 3);
    bat_curve *out_ = nullptr;
    const bat_status status = bat_curve_to_dimension(get(), dimension, &out_);
    Curve made = Curve(out_);
    detail::check(status, {{"dimension", static_cast<double>(dimension), -1e+75, 1e+75}});
    return made;
}

inline Curve Curve::insert_knot(double u, int times) const {
    detail::inside("times", times, 1, 8);
    bat_curve *out_ = nullptr;
    const bat_status status = bat_curve_insert_knot(get(), u, times, &out_);
    Curve made = Curve(out_);
    detail::check(status, {{"times", static_cast<double>(times), -1e+75, 1e+75}});
    return made;
}

inline Curve Curve::insert_knots(Numbers knots) const {
    bat_curve *out_ = nullptr;
    const bat_status status = bat_curve_insert_knots(get(), static_cast<int>(knots.size()), knots.data(), &out_);
    Curve made = Curve(out_);
    detail::check(status);
    return made;
}

inline Curve Curve::refine(Numbers knots) const {
    bat_curve *out_ = nullptr;
    const bat_status status = bat_curve_refine(get(), static_cast<int>(knots.size()), knots.data(), &out_);
    Curve made = Curve(out_);
    detail::check(status);
    return made;
}

inline CurveRemoveKnotResult Curve::remove_knot(double u, int times, double tolerance) const {
    detail::inside("times", times, 1, 8);
    bat_curve *out_ = nullptr;
    int removed_{};
    double error_{};
    const bat_status status = bat_curve_remove_knot(get(), u, times, tolerance, &out_, &removed_, &error_);
    CurveRemoveKnotResult made{Curve(out_), removed_, error_};
    detail::check(status, {{"times", static_cast<double>(times), -1e+75, 1e+75}, {"tolerance", static_cast<double>(tolerance), 0, 1e+75}});
    return made;
}

inline CurveSimplifyResult Curve::simplify(double tolerance, double corner) const {
    bat_curve *out_ = nullptr;
    double error_{};
    const bat_status status = bat_curve_simplify(get(), tolerance, corner, &out_, &error_);
    CurveSimplifyResult made{Curve(out_), error_};
    detail::check(status, {{"tolerance", static_cast<double>(tolerance), 0, 1e+75}, {"corner", static_cast<double>(corner), 0, 1e+75}});
    return made;
}

inline Curve Curve::elevate(int degree) const {
    detail::inside("degree", degree, 1, 7);
    bat_curve *out_ = nullptr;
    const bat_status status = bat_curve_elevate(get(), degree, &out_);
    Curve made = Curve(out_);
    detail::check(status);
    return made;
}

inline Curve Curve::clamp() const {
    bat_curve *out_ = nullptr;
    const bat_status status = bat_curve_clamp(get(), &out_);
    Curve made = Curve(out_);
    detail::check(status);
    return made;
}

inline Curve Curve::reverse() const {
    bat_curve *out_ = nullptr;
    const bat_status status = bat_curve_reverse(get(), &out_);
    Curve made = Curve(out_);
    detail::check(status);
    return made;
}

inline Curve Curve::reparametrise(double start, double end) const {
    bat_curve *out_ = nullptr;
    const bat_status status = bat_curve_reparametrise(get(), start, end, &out_);
    Curve made = Curve(out_);
    detail::check(status, {{"start", static_cast<double>(start), -1e+30, 1e+30}, {"end", static_cast<double>(end), -1e+30, 1e+30}});
    return made;
}

inline CurveSplitResult Curve::split(double u) const {
    bat_curve *left_ = nullptr;
    bat_curve *right_ = nullptr;
    const bat_status status = bat_curve_split(get(), u, &left_, &right_);
    CurveSplitResult made{Curve(left_), Curve(right_)};
    detail::check(status);
    return made;
}

inline Curve Curve::piece(double start, double end) const {
    bat_curve *out_ = nullptr;
    const bat_status status = bat_curve_piece(get(), start, end, &out_);
    Curve made = Curve(out_);
    detail::check(status);
    return made;
}

inline Curve Curve::open_at(double u) const {
    bat_curve *out_ = nullptr;
    const bat_status status = bat_curve_open_at(get(), u, &out_);
    Curve made = Curve(out_);
    detail::check(status);
    return made;
}

inline Curve Curve::close(double tolerance) const {
    bat_curve *out_ = nullptr;
    const bat_status status = bat_curve_close(get(), tolerance, &out_);
    Curve made = Curve(out_);
    detail::check(status, {{"tolerance", static_cast<double>(tolerance), 0, 1e+75}});
    return made;
}

inline Curve Curve::move_seam(double u) const {
    bat_curve *out_ = nullptr;
    const bat_status status = bat_curve_move_seam(get(), u, &out_);
    Curve made = Curve(out_);
    detail::check(status);
    return made;
}

inline CurveJoinResult Curve::join(const Curve &b, int continuity, double gap) const {
    bat_curve *out_ = nullptr;
    double moved_{};
    const bat_status status = bat_curve_join(get(), b.get(), continuity, gap, &out_, &moved_);
    CurveJoinResult made{Curve(out_), moved_};
    detail::check(status, {{"continuity", static_cast<double>(continuity), 0, 2}, {"gap", static_cast<double>(gap), 0, 1e+75}});
    return made;
}

inline int Curve::segment_count() const {
    return bat_curve_segment_count(get());
}

inline CurveToBezierResult Curve::to_bezier() const {
    std::vector<double> points_(static_cast<std::size_t>(segment_count())*(static_cast<std::size_t>(degree())+1)*static_cast<std::size_t>(dimension()));
    std::vector<double> breaks_(static_cast<std::size_t>(segment_count())+1);
    const bat_status status = bat_curve_to_bezier(get(), points_.data(), breaks_.data());
    CurveToBezierResult made{std::move(points_), std::move(breaks_)};
    detail::check(status);
    return made;
}

inline std::vector<double> Curve::to_cubics(double tolerance) const {
    int segments_{};
    double *points_ = nullptr;
    const bat_status status = bat_curve_to_cubics(get(), tolerance, &segments_, &points_);
    std::vector<double> made = detail::taken(points_, static_cast<std::size_t>(segments_)*4*static_cast<std::size_t>(dimension()));
    detail::check(status, {{"tolerance", static_cast<double>(tolerance), 0, 1e+75}});
    return made;
}

inline Curve Curve::drag(Numbers u, Numbers delta) const {
    detail::exactly("delta", delta.size(), u.size()*static_cast<std::size_t>(dimension()));
    bat_curve *out_ = nullptr;
    const bat_status status = bat_curve_drag(get(), u.size(), u.data(), delta.data(), &out_);
    Curve made = Curve(out_);
    detail::check(status);
    return made;
}

inline Curve Curve::move_point(int index, Numbers delta) const {
    detail::exactly("delta", delta.size(), static_cast<std::size_t>(dimension()));
    bat_curve *out_ = nullptr;
    const bat_status status = bat_curve_move_point(get(), index, delta.data(), &out_);
    Curve made = Curve(out_);
    detail::check(status);
    return made;
}

inline double Curve::length(std::optional<double> u0, std::optional<double> u1, double relative) const {
    return bat_curve_length(get(), u0.value_or(domain()[0]), u1.value_or(domain()[1]), relative);
}

inline double Curve::at_length(double s, std::optional<double> u0, double relative) const {
    return bat_curve_at_length(get(), u0.value_or(domain()[0]), s, relative);
}

inline CurveBoundsResult Curve::bounds() const {
    std::vector<double> low_(static_cast<std::size_t>(dimension()));
    std::vector<double> high_(static_cast<std::size_t>(dimension()));
    bat_curve_bounds(get(), low_.data(), high_.data());
    return {std::move(low_), std::move(high_)};
}

inline double Curve::area() const {
    return bat_curve_area(get());
}

inline double Curve::curvature(double u) const {
    return bat_curve_curvature(get(), u);
}

inline std::vector<double> Curve::inflections() const {
    std::vector<double> u_;
    size_t room = 0;
    room = bat_curve_inflections(get(), room, u_.data());
    u_.resize(static_cast<std::size_t>(room));
    bat_curve_inflections(get(), room, u_.data());
    return u_;
}

inline std::vector<double> Curve::extremes(int axis) const {
    std::vector<double> u_;
    size_t room = 0;
    room = bat_curve_extremes(get(), axis, room, u_.data());
    u_.resize(static_cast<std::size_t>(room));
    bat_curve_extremes(get(), axis, room, u_.data());
    return u_;
}

inline CurveDistanceResult Curve::distance(const Curve &b, int per_span) const {
    detail::inside("per_span", per_span, 1, 4096);
    double a_to_b_{};
    double b_to_a_{};
    const bat_status status = bat_curve_distance(get(), b.get(), per_span, &a_to_b_, &b_to_a_);
    CurveDistanceResult made{a_to_b_, b_to_a_};
    detail::check(status, {{"per_span", static_cast<double>(per_span), -1e+75, 1e+75}});
    return made;
}

inline bat_near Curve::nearest(Numbers point) const {
    detail::exactly("point", point.size(), static_cast<std::size_t>(dimension()));
    bat_near out_{};
    const bat_status status = bat_curve_nearest(get(), point.data(), &out_);
    detail::check(status);
    return out_;
}

inline std::vector<bat_near> Curve::nearest_all(Numbers point, double within) const {
    detail::exactly("point", point.size(), static_cast<std::size_t>(dimension()));
    size_t count_{};
    std::vector<bat_near> out_;
    size_t room = 0;
    detail::check(bat_curve_nearest_all(get(), point.data(), within, room, out_.data(), &count_));
    room = count_;
    out_.resize(static_cast<std::size_t>(room));
    detail::check(bat_curve_nearest_all(get(), point.data(), within, room, out_.data(), &count_));
    return out_;
}

inline double Curve::project_near(Numbers point, double u, int steps) const {
    detail::exactly("point", point.size(), static_cast<std::size_t>(dimension()));
    detail::inside("steps", steps, 0, 4096);
    return bat_curve_project_near(get(), point.data(), u, steps);
}

inline Finder Curve::finder() const {
    bat_finder *out_ = nullptr;
    const bat_status status = bat_finder_create(get(), &out_);
    Finder made = Finder(out_, dimension());
    detail::check(status);
    return made;
}

inline bat_near Finder::nearest(Numbers point) const {
    detail::exactly("point", point.size(), static_cast<std::size_t>(dimension_));
    bat_near out_{};
    bat_finder_nearest(get(), point.data(), &out_);
    return out_;
}

inline bat_apart Curve::hausdorff(const Curve &b, double precision) const {
    bat_apart out_{};
    const bat_status status = bat_curve_hausdorff(get(), b.get(), precision, &out_);
    detail::check(status, {{"precision", static_cast<double>(precision), 0, 1e+75, true}});
    return out_;
}

inline detail::Owned<bat_meeting, bat_meeting_free> Curve::intersect(const Curve &b, double tolerance) const {
    bat_meeting out_{};
    const bat_status status = bat_curve_intersect(get(), b.get(), tolerance, &out_);
    detail::check(status, {{"tolerance", static_cast<double>(tolerance), 0, 1e+75, true}});
    return detail::Owned<bat_meeting, bat_meeting_free>(out_);
}

inline detail::Owned<bat_meeting, bat_meeting_free> Curve::self_intersect(double tolerance) const {
    bat_meeting out_{};
    const bat_status status = bat_curve_self_intersect(get(), tolerance, &out_);
    detail::check(status, {{"tolerance", static_cast<double>(tolerance), 0, 1e+75, true}});
    return detail::Owned<bat_meeting, bat_meeting_free>(out_);
}

inline CurveFlattenResult Curve::flatten(double tolerance) const {
    size_t count_{};
    double *points_ = nullptr;
    double *u_ = nullptr;
    const bat_status status = bat_curve_flatten(get(), tolerance, &count_, &points_, &u_);
    CurveFlattenResult made{detail::taken(points_, static_cast<std::size_t>(count_)*static_cast<std::size_t>(dimension())), detail::taken(u_, static_cast<std::size_t>(count_))};
    detail::check(status, {{"tolerance", static_cast<double>(tolerance), 0, 1e+75, true}});
    return made;
}

inline CurveArcsResult Curve::arcs(double tolerance, double corner) const {
    size_t count_{};
    bat_arc *arcs_ = nullptr;
    double max_error_{};
    const bat_status status = bat_curve_arcs(get(), tolerance, corner, &count_, &arcs_, &max_error_);
    CurveArcsResult made{detail::taken(arcs_, static_cast<std::size_t>(count_)), max_error_};
    detail::check(status, {{"tolerance", static_cast<double>(tolerance), 0, 1e+75, true}, {"corner", static_cast<double>(corner), 0, 1e+75}});
    return made;
}

inline CurveOffsetResult Curve::offset(double distance, double tolerance, double corner) const {
    size_t count_{};
    bat_curve **curves_ = nullptr;
    double max_error_{};
    const bat_status status = bat_curve_offset(get(), distance, tolerance, corner, &count_, &curves_, &max_error_);
    CurveOffsetResult made{detail::taken_objects<Curve>(curves_, static_cast<std::size_t>(count_)), max_error_, status == BAT_OK};
    if (status != BAT_OK && !(status == BAT_TOLERANCE && (curves_ != nullptr))) detail::check(status, {{"distance", static_cast<double>(distance), -1e+75, 1e+75}, {"tolerance", static_cast<double>(tolerance), 0, 1e+75, true}, {"corner", static_cast<double>(corner), 0, 1e+75}});
    return made;
}

inline CurveRefitResult Curve::refit(double tolerance, double corner) const {
    bat_curve *out_ = nullptr;
    double error_{};
    const bat_status status = bat_curve_refit(get(), tolerance, corner, &out_, &error_);
    CurveRefitResult made{Curve(out_), error_};
    detail::check(status, {{"tolerance", static_cast<double>(tolerance), 0, 1e+75}, {"corner", static_cast<double>(corner), 0, 1e+75}});
    return made;
}

inline CurveRefitG1Result Curve::refit_g1(double tolerance, double corner) const {
    bat_curve *out_ = nullptr;
    double error_{};
    const bat_status status = bat_curve_refit_g1(get(), tolerance, corner, &out_, &error_);
    CurveRefitG1Result made{Curve(out_), error_};
    detail::check(status, {{"tolerance", static_cast<double>(tolerance), 0, 1e+75}, {"corner", static_cast<double>(corner), 0, 1e+75}});
    return made;
}

inline CurveRefitExtremesResult Curve::refit_extremes(double tolerance, double corner, double grid) const {
    bat_curve *out_ = nullptr;
    double error_{};
    const bat_status status = bat_curve_refit_extremes(get(), tolerance, corner, grid, &out_, &error_);
    CurveRefitExtremesResult made{Curve(out_), error_};
    detail::check(status, {{"tolerance", static_cast<double>(tolerance), 0, 1e+75, true}, {"corner", static_cast<double>(corner), 0, 1e+75}, {"grid", static_cast<double>(grid), 0, 1e+75}});
    return made;
}

inline CurveFramesAtResult Curve::frames_at(Numbers u, const bat_frame_options *options) const {
    std::vector<bat_frame3> frames_(u.size());
    double holonomy_{};
    const bat_status status = bat_frames(get(), u.size(), u.data(), options, frames_.data(), &holonomy_);
    CurveFramesAtResult made{std::move(frames_), holonomy_};
    detail::check(status);
    return made;
}

inline Chain Curve::frame_chain(const bat_frame_options *options) const {
    bat_frame_chain *out_ = nullptr;
    const bat_status status = bat_frame_chain_create(get(), options, &out_);
    Chain made = Chain(out_);
    detail::check(status);
    return made;
}

inline bat_frame3 Chain::at(double u) const {
    bat_frame3 out_{};
    bat_frame_chain_at(get(), u, &out_);
    return out_;
}

inline double Chain::holonomy() const {
    return bat_frame_chain_holonomy(get());
}

inline bat_frame_options Chain::follow() const {
    bat_frame_options options_ = bat_frame_defaults();
    bat_frame_chain_follow(get(), &options_);
    return options_;
}

inline CurveSketchResult Curve::sketch(const bat_stroke &stroke, const bat_sketch_options *options) const {
    bat_curve *out_ = nullptr;
    bat_sketch_report report_{};
    const bat_status status = bat_sketch(get(), &stroke, options, &out_, &report_);
    CurveSketchResult made{Curve(out_), report_, status == BAT_OK};
    if (status != BAT_OK && !(status == BAT_TOLERANCE && (out_ != nullptr))) detail::check(status);
    return made;
}

inline CurveSmoothResult Curve::smooth(const bat_stroke &stroke, const bat_sketch_options *options) const {
    bat_curve *out_ = nullptr;
    bat_sketch_report report_{};
    const bat_status status = bat_sketch_smooth(get(), &stroke, options, &out_, &report_);
    CurveSmoothResult made{Curve(out_), report_};
    detail::check(status);
    return made;
}

inline Curve Curve::calm(Numbers range, double limit, double pixel) const {
    detail::exactly("range", range.size(), 2);
    bat_curve *out_ = nullptr;
    const bat_status status = bat_sketch_calm(get(), range.data(), limit, pixel, &out_);
    Curve made = Curve(out_);
    detail::check(status, {{"limit", static_cast<double>(limit), 0, 1e+75, true}, {"pixel", static_cast<double>(pixel), 0, 1e+75, true}});
    return made;
}

inline CurveSketchJoinResult Curve::sketch_join(const Curve &b, const bat_stroke &stroke, const bat_sketch_options *options) const {
    bat_curve *out_ = nullptr;
    bat_sketch_report report_{};
    const bat_status status = bat_sketch_join(get(), b.get(), &stroke, options, &out_, &report_);
    CurveSketchJoinResult made{Curve(out_), report_};
    detail::check(status);
    return made;
}

inline LiveSketch Curve::live(const bat_sketch_options *options, bat_sketch_kind kind) const {
    bat_sketch_live *out_ = nullptr;
    const bat_status status = bat_sketch_live_begin(get(), dimension(), kind, options, &out_);
    LiveSketch made = LiveSketch(out_);
    detail::check(status);
    return made;
}

inline void LiveSketch::add_many(const bat_stroke &samples) {
    const bat_status status = bat_sketch_live_add(get(), &samples);
    detail::check(status);
}

inline LivesketchPreviewResult LiveSketch::preview() {
    bat_curve *out_ = nullptr;
    bat_sketch_live_info info_{};
    const bat_status status = bat_sketch_live_preview(get(), &out_, &info_);
    LivesketchPreviewResult made{Curve(out_), info_};
    detail::check(status);
    return made;
}

inline LivesketchCommitResult LiveSketch::commit() {
    bat_curve *out_ = nullptr;
    bat_sketch_report report_{};
    const bat_status status = bat_sketch_live_commit(release(), &out_, &report_);
    LivesketchCommitResult made{Curve(out_), report_};
    detail::check(status);
    return made;
}

inline Shape Curve::shape(const bat_shape_options *options) const {
    bat_shape *out_ = nullptr;
    const bat_status status = bat_shape_create(get(), options, &out_);
    Shape made = Shape(out_);
    detail::check(status);
    return made;
}

inline Shape Shape::copy() const {
    bat_shape *out_ = nullptr;
    const bat_status status = bat_shape_copy(get(), &out_);
    Shape made = Shape(out_);
    detail::check(status);
    return made;
}

inline void Shape::add_level(Numbers knots) {
    const bat_status status = bat_shape_add_level(get(), static_cast<int>(knots.size()), knots.empty() ? nullptr : knots.data(), nullptr, nullptr);
    detail::check(status);
}

inline int Shape::levels() const {
    return bat_shape_levels(get());
}

inline std::optional<Curve> Shape::curve(int level) const {
    detail::inside("level", level, 0, levels());
    const bat_curve *found = bat_shape_curve(get(), level);
    if (found == nullptr) return std::nullopt;
    return Curve(detail::copy_of<Curve>(found, bat_curve_copy));
}

inline Curve Shape::flatten() const {
    bat_curve *out_ = nullptr;
    const bat_status status = bat_shape_flatten(get(), &out_);
    Curve made = Curve(out_);
    detail::check(status);
    return made;
}

inline Span<const double> Shape::details(int level) const {
    detail::inside("level", level, 1, levels());
    const double *found = bat_shape_details(get(), level);
    return Span<const double>(found, found == nullptr ? 0 : static_cast<std::size_t>(bat_curve_count(bat_shape_curve(get(), level)))*3);
}

inline Span<const double> Shape::nodes(int level) const {
    detail::inside("level", level, 1, levels());
    const double *found = bat_shape_nodes(get(), level);
    return Span<const double>(found, found == nullptr ? 0 : static_cast<std::size_t>(bat_curve_count(bat_shape_curve(get(), level))));
}

inline Span<const int> Shape::source(int level) const {
    detail::inside("level", level, 1, levels());
    const int *found = bat_shape_source(get(), level);
    return Span<const int>(found, found == nullptr ? 0 : static_cast<std::size_t>(bat_curve_count(bat_shape_curve(get(), level))));
}

inline double Shape::gain(int level) const {
    detail::inside("level", level, 1, levels());
    return bat_shape_gain(get(), level);
}

inline bool Shape::is_muted(int level) const {
    detail::inside("level", level, 1, levels());
    return bat_shape_is_muted(get(), level);
}

inline const bat_shape_options *Shape::options() const {
    return bat_shape_options_of(get());
}

inline void Shape::move(int level, int index, Numbers delta) {
    detail::exactly("delta", delta.size(), static_cast<std::size_t>(bat_curve_dimension(bat_shape_curve(get(), 0))));
    const bat_status status = bat_shape_move(get(), level, index, delta.data());
    detail::check(status);
}

inline void Shape::drag(int level, double u, Numbers delta) {
    detail::exactly("delta", delta.size(), static_cast<std::size_t>(bat_curve_dimension(bat_shape_curve(get(), 0))));
    const bat_status status = bat_shape_drag(get(), level, u, delta.data());
    detail::check(status);
}

inline double Shape::drag_finest(int level, double u, Numbers delta, double tolerance) {
    detail::exactly("delta", delta.size(), static_cast<std::size_t>(bat_curve_dimension(bat_shape_curve(get(), 0))));
    double left_{};
    const bat_status status = bat_shape_drag_finest(get(), level, u, delta.data(), tolerance, &left_);
    detail::check(status, {{"tolerance", static_cast<double>(tolerance), 0, 1e+75, true}});
    return left_;
}

inline void Shape::move_many(int level, int first, Numbers deltas) {
    const bat_status status = bat_shape_move_many(get(), level, first, detail::many("deltas", deltas.size(), static_cast<std::size_t>(bat_curve_dimension(bat_shape_curve(get(), 0)))), deltas.data());
    detail::check(status);
}

inline void Shape::set_gain(int level, double gain) {
    const bat_status status = bat_shape_set_gain(get(), level, gain);
    detail::check(status, {{"gain", static_cast<double>(gain), -1e+75, 1e+75}});
}

inline void Shape::set_muted(int level, bool muted) {
    const bat_status status = bat_shape_set_muted(get(), level, muted);
    detail::check(status);
}

inline void Shape::sketch(int level, Numbers u, Numbers targets) {
    detail::exactly("targets", targets.size(), u.size()*static_cast<std::size_t>(bat_curve_dimension(bat_shape_curve(get(), 0))));
    const bat_status status = bat_shape_sketch(get(), level, u.size(), u.data(), targets.data());
    detail::check(status);
}

inline bat_sketch_report Shape::redraw_level(int level, const bat_stroke &stroke, const bat_sketch_options *options) {
    bat_sketch_report report_{};
    const bat_status status = bat_shape_redraw_level(get(), level, &stroke, options, &report_);
    detail::check(status);
    return report_;
}

inline ShapeRedrawResult Shape::redraw(const bat_stroke &stroke, const bat_sketch_options *options, bool drop) const {
    bat_shape *out_ = nullptr;
    bat_sketch_report report_{};
    const bat_status status = bat_shape_redraw(get(), &stroke, drop, options, &out_, &report_);
    ShapeRedrawResult made{Shape(out_), report_, status == BAT_OK};
    if (status != BAT_OK && !(status == BAT_TOLERANCE && (out_ != nullptr))) detail::check(status);
    return made;
}

inline void Shape::transform(Numbers matrix) {
    detail::exactly("matrix", matrix.size(), static_cast<std::size_t>(bat_curve_dimension(bat_shape_curve(get(), 0)))*(static_cast<std::size_t>(bat_curve_dimension(bat_shape_curve(get(), 0)))+1));
    const bat_status status = bat_shape_transform(get(), matrix.data());
    detail::check(status);
}

inline void Shape::reframe(Numbers matrix, bat_frame_rule rule) {
    if (!matrix.empty()) detail::exactly("matrix", matrix.size(), static_cast<std::size_t>(bat_curve_dimension(bat_shape_curve(get(), 0)))*(static_cast<std::size_t>(bat_curve_dimension(bat_shape_curve(get(), 0)))+1));
    const bat_status status = bat_shape_reframe(get(), matrix.empty() ? nullptr : matrix.data(), rule);
    detail::check(status);
}

inline Shape Shape::to_dimension(int dimension) const {
    detail::inside("dimension", dimension, 2, 3);
    bat_shape *out_ = nullptr;
    const bat_status status = bat_shape_to_dimension(get(), dimension, &out_);
    Shape made = Shape(out_);
    detail::check(status, {{"dimension", static_cast<double>(dimension), -1e+75, 1e+75}});
    return made;
}

inline void Shape::commit() {
    const bat_status status = bat_shape_commit(get());
    detail::check(status);
}

inline LiveShape Shape::live(int level) const {
    bat_shape_live *out_ = nullptr;
    const bat_status status = bat_shape_live_begin(get(), level, &out_);
    LiveShape made = LiveShape(out_);
    detail::check(status);
    return made;
}

inline void LiveShape::move(int first, Numbers deltas) {
    const bat_status status = bat_shape_live_move(get(), first, detail::many("deltas", deltas.size(), static_cast<std::size_t>(bat_curve_dimension(bat_shape_curve(bat_shape_live_shape(get()), 0)))), deltas.data());
    detail::check(status, {{"first", static_cast<double>(first), 0, 1000000000.0}});
}

inline void LiveShape::drag(double u, Numbers delta) {
    detail::exactly("delta", delta.size(), static_cast<std::size_t>(bat_curve_dimension(bat_shape_curve(bat_shape_live_shape(get()), 0))));
    const bat_status status = bat_shape_live_drag(get(), u, delta.data());
    detail::check(status);
}

inline double LiveShape::drag_finest(double u, Numbers delta, double tolerance) {
    detail::exactly("delta", delta.size(), static_cast<std::size_t>(bat_curve_dimension(bat_shape_curve(bat_shape_live_shape(get()), 0))));
    double left_{};
    const bat_status status = bat_shape_live_drag_finest(get(), u, delta.data(), tolerance, &left_);
    detail::check(status, {{"tolerance", static_cast<double>(tolerance), 0, 1e+75, true}});
    return left_;
}

inline std::optional<Shape> LiveShape::shape() const {
    const bat_shape *found = bat_shape_live_shape(get());
    if (found == nullptr) return std::nullopt;
    return Shape(detail::copy_of<Shape>(found, bat_shape_copy));
}

inline LiveshapeTouchedResult LiveShape::touched(int level) const {
    detail::inside("level", level, 0, bat_shape_levels(bat_shape_live_shape(get())));
    int first_{};
    size_t points_{};
    bat_shape_live_touched(get(), level, &first_, &points_);
    return {first_, points_};
}

inline Shape LiveShape::commit() {
    bat_shape *out_ = nullptr;
    const bat_status status = bat_shape_live_commit(release(), &out_);
    Shape made = Shape(out_);
    detail::check(status);
    return made;
}

inline Shape Curve::levels(int levels, const bat_shape_options *options) const {
    bat_shape *out_ = nullptr;
    const bat_status status = bat_shape_decompose(get(), levels, options, &out_);
    Shape made = Shape(out_);
    detail::check(status, {{"levels", static_cast<double>(levels), 1, 64}});
    return made;
}

inline Shape Curve::levels_to(int levels, size_t coarsest, const bat_shape_options *options) const {
    bat_shape *out_ = nullptr;
    const bat_status status = bat_shape_decompose_to(get(), levels, coarsest, options, &out_);
    Shape made = Shape(out_);
    detail::check(status, {{"levels", static_cast<double>(levels), 1, 64}});
    return made;
}

inline Shape Shape::copy_levels(const Curve &onto) const {
    bat_shape *out_ = nullptr;
    const bat_status status = bat_shape_copy_levels(get(), onto.get(), &out_);
    Shape made = Shape(out_);
    detail::check(status);
    return made;
}

inline CurveBlendResult Curve::blend(const Curve &b, const bat_blend_options *options, bool a_end, bool b_end) const {
    bat_curve *out_ = nullptr;
    double variation_{};
    const bat_status status = bat_curve_blend(get(), a_end, b.get(), b_end, options, &out_, &variation_);
    CurveBlendResult made{Curve(out_), variation_};
    detail::check(status);
    return made;
}

inline CurveMatchResult Curve::match(const Curve &b, bool a_end, bool b_end, int continuity, double tension) const {
    bat_curve *out_ = nullptr;
    double moved_{};
    const bat_status status = bat_curve_match(get(), a_end, b.get(), b_end, continuity, tension, &out_, &moved_);
    CurveMatchResult made{Curve(out_), moved_};
    detail::check(status, {{"continuity", static_cast<double>(continuity), 0, 3}, {"tension", static_cast<double>(tension), 0, 1e+75, true}});
    return made;
}

inline std::array<double, 4> Curve::jump(const Curve &b, bool a_end, bool b_end) const {
    std::array<double, 4> jump_{};
    const bat_status status = bat_curve_jump(get(), a_end, b.get(), b_end, jump_.data());
    detail::check(status);
    return jump_;
}

inline CurveOutlineResult Curve::outline(const bat_nib &nib, double tolerance, double corner) const {
    size_t count_{};
    bat_curve **curves_ = nullptr;
    double max_error_{};
    const bat_status status = bat_curve_outline(get(), &nib, tolerance, corner, &count_, &curves_, &max_error_);
    CurveOutlineResult made{detail::taken_objects<Curve>(curves_, static_cast<std::size_t>(count_)), max_error_, status == BAT_OK};
    if (status != BAT_OK && !(status == BAT_TOLERANCE && (curves_ != nullptr))) detail::check(status, {{"tolerance", static_cast<double>(tolerance), 0, 1e+75, true}, {"corner", static_cast<double>(corner), 0, 1e+75}});
    return made;
}

inline CurveOutlineWidthResult Curve::outline_width(const bat_nib &nib, const bat_width_profile &profile, double tolerance, double corner) const {
    size_t count_{};
    bat_curve **curves_ = nullptr;
    double max_error_{};
    bat_problem problem{};
    const bat_status status = bat_curve_outline_width(get(), &nib, &profile, tolerance, corner, &count_, &curves_, &max_error_);
    CurveOutlineWidthResult made{detail::taken_objects<Curve>(curves_, static_cast<std::size_t>(count_)), max_error_};
    if (status != BAT_OK) detail::check(bat_width_check(&profile, &problem), problem);
    detail::check(status, {{"tolerance", static_cast<double>(tolerance), 0, 1e+75, true}, {"corner", static_cast<double>(corner), 0, 1e+75}});
    return made;
}

inline std::vector<double> Curve::cover_width(const bat_nib &nib, const bat_width_profile &profile, double tolerance, double corner) const {
    size_t cubics_{};
    double *points_ = nullptr;
    bat_problem problem{};
    const bat_status status = bat_curve_cover_width(get(), &nib, &profile, tolerance, corner, &cubics_, &points_);
    std::vector<double> made = detail::taken(points_, static_cast<std::size_t>(cubics_)*4*static_cast<std::size_t>(dimension()));
    if (status != BAT_OK) detail::check(bat_width_check(&profile, &problem), problem);
    detail::check(status, {{"tolerance", static_cast<double>(tolerance), 0, 1e+75, true}, {"corner", static_cast<double>(corner), 0, 1e+75}});
    return made;
}

inline Surface Surface::copy() const {
    bat_surface *out_ = nullptr;
    const bat_status status = bat_surface_copy(get(), &out_);
    Surface made = Surface(out_);
    detail::check(status);
    return made;
}

inline int Surface::degree(bat_direction direction) const {
    return bat_surface_degree(get(), direction);
}

inline bool Surface::is_closed(bat_direction direction) const {
    return bat_surface_is_closed(get(), direction);
}

inline size_t Surface::count(bat_direction direction) const {
    return bat_surface_count(get(), direction);
}

inline int Surface::knot_count(bat_direction direction) const {
    return bat_surface_knot_count(get(), direction);
}

inline Span<const double> Surface::knots(bat_direction direction) const {
    const double *found = bat_surface_knots(get(), direction);
    return Span<const double>(found, found == nullptr ? 0 : static_cast<std::size_t>(knot_count(direction)));
}

inline std::array<double, 2> Surface::domain(bat_direction direction) const {
    std::array<double, 2> domain_{};
    bat_surface_domain(get(), direction, domain_.data());
    return domain_;
}

inline SurfaceBoxResult Surface::box() const {
    std::array<double, 3> low_{};
    std::array<double, 3> high_{};
    bat_surface_box(get(), low_.data(), high_.data());
    return {low_, high_};
}

inline double Surface::size() const {
    return bat_surface_size(get());
}

inline bool Surface::is_equal(const Surface &b) const {
    return bat_surface_is_equal(get(), b.get());
}

inline Surface Surface::transform(Numbers matrix) const {
    detail::exactly("matrix", matrix.size(), 12);
    bat_surface *out_ = nullptr;
    const bat_status status = bat_surface_transform(get(), matrix.data(), &out_);
    Surface made = Surface(out_);
    detail::check(status);
    return made;
}

inline std::vector<double> Surface::at(double u, double v, int order) const {
    detail::inside("order", order, 0, 2);
    std::vector<double> out_((static_cast<std::size_t>(order)*static_cast<std::size_t>(order)/2+static_cast<std::size_t>(order)*3/2+1)*3);
    bat_surface_eval(get(), u, v, order, out_.data());
    return out_;
}

inline std::vector<double> Surface::at_grid(Numbers u, Numbers v, int order) const {
    detail::inside("order", order, 0, 2);
    std::vector<double> out_(u.size()*v.size()*(static_cast<std::size_t>(order)*static_cast<std::size_t>(order)/2+static_cast<std::size_t>(order)*3/2+1)*3);
    const bat_status status = bat_surface_eval_grid(get(), u.size(), u.data(), v.size(), v.data(), order, out_.data());
    detail::check(status, {{"order", static_cast<double>(order), -1e+75, 1e+75}});
    return out_;
}

inline SurfaceNormalGridResult Surface::normal_grid(Numbers u, Numbers v) const {
    std::vector<double> points_(u.size()*v.size()*3);
    std::vector<double> normals_(u.size()*v.size()*3);
    const bat_status status = bat_surface_normal_grid(get(), u.size(), u.data(), v.size(), v.data(), points_.data(), normals_.data());
    SurfaceNormalGridResult made{std::move(points_), std::move(normals_)};
    detail::check(status);
    return made;
}

inline std::vector<double> Surface::spread(bat_direction direction, size_t count) const {
    std::vector<double> u_(static_cast<std::size_t>(count));
    bat_surface_spread(get(), direction, count, u_.data());
    return u_;
}

inline std::array<double, 3> Surface::normal(double u, double v) const {
    std::array<double, 3> normal_{};
    const bat_status status = bat_surface_normal(get(), u, v, normal_.data());
    detail::check(status, {{"v", static_cast<double>(v), -1e+75, 1e+75}});
    return normal_;
}

inline SurfaceCurvatureResult Surface::curvature(double u, double v) const {
    double gauss_{};
    double mean_{};
    const bat_status status = bat_surface_curvature(get(), u, v, &gauss_, &mean_);
    SurfaceCurvatureResult made{gauss_, mean_};
    detail::check(status, {{"v", static_cast<double>(v), -1e+75, 1e+75}});
    return made;
}

inline Curve Surface::isocurve(bat_direction direction, double at) const {
    bat_curve *out_ = nullptr;
    const bat_status status = bat_surface_isocurve(get(), direction, at, &out_);
    Curve made = Curve(out_);
    detail::check(status, {{"at", static_cast<double>(at), -1e+75, 1e+75}});
    return made;
}

inline bat_surface_point Surface::nearest(Numbers point) const {
    detail::exactly("point", point.size(), 3);
    bat_surface_point out_{};
    const bat_status status = bat_surface_nearest(get(), point.data(), &out_);
    detail::check(status);
    return out_;
}

inline std::vector<bat_surface_point> Surface::hits(Numbers origin, Numbers direction) const {
    detail::exactly("origin", origin.size(), 3);
    detail::exactly("direction", direction.size(), 3);
    size_t count_{};
    std::vector<bat_surface_point> out_;
    size_t room = 0;
    detail::check(bat_surface_hits(get(), origin.data(), direction.data(), room, out_.data(), &count_));
    room = count_;
    out_.resize(static_cast<std::size_t>(room));
    detail::check(bat_surface_hits(get(), origin.data(), direction.data(), room, out_.data(), &count_));
    return out_;
}

inline SurfaceFinder Surface::finder() const {
    bat_surface_finder *out_ = nullptr;
    const bat_status status = bat_surface_finder_create(get(), &out_);
    SurfaceFinder made = SurfaceFinder(out_);
    detail::check(status);
    return made;
}

inline bat_surface_point SurfaceFinder::nearest(Numbers point) const {
    detail::exactly("point", point.size(), 3);
    bat_surface_point out_{};
    const bat_status status = bat_surface_finder_nearest(get(), point.data(), &out_);
    detail::check(status);
    return out_;
}

inline std::vector<bat_surface_point> SurfaceFinder::hits(Numbers origin, Numbers direction) const {
    detail::exactly("origin", origin.size(), 3);
    detail::exactly("direction", direction.size(), 3);
    size_t count_{};
    std::vector<bat_surface_point> out_;
    size_t room = 0;
    detail::check(bat_surface_finder_hits(get(), origin.data(), direction.data(), room, out_.data(), &count_));
    room = count_;
    out_.resize(static_cast<std::size_t>(room));
    detail::check(bat_surface_finder_hits(get(), origin.data(), direction.data(), room, out_.data(), &count_));
    return out_;
}

inline Surface Surface::insert_knots(bat_direction direction, Numbers knots) const {
    bat_surface *out_ = nullptr;
    const bat_status status = bat_surface_insert_knots(get(), direction, static_cast<int>(knots.size()), knots.data(), &out_);
    Surface made = Surface(out_);
    detail::check(status);
    return made;
}

inline Surface Surface::refine(bat_direction direction, Numbers knots) const {
    bat_surface *out_ = nullptr;
    const bat_status status = bat_surface_refine(get(), direction, static_cast<int>(knots.size()), knots.data(), &out_);
    Surface made = Surface(out_);
    detail::check(status);
    return made;
}

inline SurfaceRedrawResult Surface::redraw(bat_direction direction, double at, const Curve &line, const bat_surface_redraw_options *options) const {
    bat_surface *out_ = nullptr;
    std::vector<double> weights_(static_cast<std::size_t>(count(direction)));
    bat_surface_redraw_report report_{};
    const bat_status status = bat_surface_redraw(get(), direction, at, line.get(), options, &out_, weights_.data(), &report_);
    SurfaceRedrawResult made{Surface(out_), std::move(weights_), report_};
    detail::check(status, {{"at", static_cast<double>(at), -1e+75, 1e+75}});
    return made;
}

inline SurfaceTessellateResult Surface::tessellate(const bat_tessellate_options *options) const {
    bat_tessellation *out_ = nullptr;
    bat_tessellate_report report_{};
    const bat_status status = bat_surface_tessellate(get(), options, &out_, &report_);
    SurfaceTessellateResult made{Tessellation(out_), report_};
    detail::check(status);
    return made;
}

inline std::array<size_t, 2> Tessellation::update(const Surface &surface, bat_direction direction, Numbers moved) {
    detail::exactly("moved", moved.size(), 2);
    std::array<size_t, 2> range_{};
    const bat_status status = bat_tessellation_update(get(), surface.get(), direction, moved.data(), range_.data());
    detail::check(status);
    return range_;
}

inline Relief Surface::relief() const {
    bat_relief *out_ = nullptr;
    const bat_status status = bat_relief_create(get(), &out_);
    Relief made = Relief(out_);
    detail::check(status);
    return made;
}

inline Relief Relief::copy() const {
    bat_relief *out_ = nullptr;
    const bat_status status = bat_relief_copy(get(), &out_);
    Relief made = Relief(out_);
    detail::check(status);
    return made;
}

inline void Relief::add_level(Span<const int> knot_count, Numbers u_knots, Numbers v_knots, Numbers details, Span<const int> source) {
    detail::exactly("knot_count", knot_count.size(), 2);
    detail::many("details", details.size(), 3);
    const bat_status status = bat_relief_add_level(get(), knot_count.data(), u_knots.empty() ? nullptr : u_knots.data(), v_knots.empty() ? nullptr : v_knots.data(), details.empty() ? nullptr : details.data(), source.empty() ? nullptr : source.data());
    detail::check(status);
}

inline int Relief::levels() const {
    return bat_relief_levels(get());
}

inline std::optional<Surface> Relief::surface(int level) const {
    detail::inside("level", level, 0, levels());
    const bat_surface *found = bat_relief_surface(get(), level);
    if (found == nullptr) return std::nullopt;
    return Surface(detail::copy_of<Surface>(found, bat_surface_copy));
}

inline Span<const double> Relief::details(int level) const {
    detail::inside("level", level, 1, levels());
    const double *found = bat_relief_details(get(), level);
    return Span<const double>(found, found == nullptr ? 0 : static_cast<std::size_t>(bat_surface_count(bat_relief_surface(get(), level), BAT_U)) * static_cast<std::size_t>(bat_surface_count(bat_relief_surface(get(), level), BAT_V))*3);
}

inline Span<const int> Relief::source(int level) const {
    detail::inside("level", level, 1, levels());
    const int *found = bat_relief_source(get(), level);
    return Span<const int>(found, found == nullptr ? 0 : static_cast<std::size_t>(bat_surface_count(bat_relief_surface(get(), level), BAT_U)) * static_cast<std::size_t>(bat_surface_count(bat_relief_surface(get(), level), BAT_V)));
}

inline double Relief::gain(int level) const {
    detail::inside("level", level, 1, levels());
    return bat_relief_gain(get(), level);
}

inline bool Relief::is_muted(int level) const {
    detail::inside("level", level, 1, levels());
    return bat_relief_is_muted(get(), level);
}

inline void Relief::move(int level, Span<const size_t> index, Numbers deltas) {
    detail::exactly("deltas", deltas.size(), index.size()*3);
    const bat_status status = bat_relief_move(get(), level, index.size(), index.data(), deltas.data());
    detail::check(status);
}

inline void Relief::drag(int level, double u, double v, Numbers delta) {
    detail::exactly("delta", delta.size(), 3);
    const bat_status status = bat_relief_drag(get(), level, u, v, delta.data());
    detail::check(status, {{"v", static_cast<double>(v), -1e+75, 1e+75}});
}

inline double Relief::drag_finest(int level, double u, double v, Numbers delta, double tolerance) {
    detail::exactly("delta", delta.size(), 3);
    double left_{};
    const bat_status status = bat_relief_drag_finest(get(), level, u, v, delta.data(), tolerance, &left_);
    detail::check(status, {{"v", static_cast<double>(v), -1e+75, 1e+75}, {"tolerance", static_cast<double>(tolerance), 0, 1e+75, true}});
    return left_;
}

inline bat_surface_redraw_report Relief::redraw(int level, bat_direction direction, double at, const Curve &line, const bat_surface_redraw_options *options) {
    bat_surface_redraw_report report_{};
    const bat_status status = bat_relief_redraw(get(), level, direction, at, line.get(), options, nullptr, &report_);
    detail::check(status, {{"at", static_cast<double>(at), -1e+75, 1e+75}});
    return report_;
}

inline void Relief::set_gain(int level, double gain) {
    const bat_status status = bat_relief_set_gain(get(), level, gain);
    detail::check(status, {{"gain", static_cast<double>(gain), -1e+75, 1e+75}});
}

inline void Relief::set_muted(int level, bool muted) {
    const bat_status status = bat_relief_set_muted(get(), level, muted);
    detail::check(status);
}

inline void Relief::transform(Numbers matrix) {
    detail::exactly("matrix", matrix.size(), 12);
    const bat_status status = bat_relief_transform(get(), matrix.data());
    detail::check(status);
}

inline Relief Surface::levels(int levels) const {
    bat_relief *out_ = nullptr;
    const bat_status status = bat_relief_decompose(get(), levels, &out_);
    Relief made = Relief(out_);
    detail::check(status, {{"levels", static_cast<double>(levels), 1, 64}});
    return made;
}

inline Relief Surface::levels_to(int levels, Span<const size_t> coarsest) const {
    detail::exactly("coarsest", coarsest.size(), 2);
    bat_relief *out_ = nullptr;
    const bat_status status = bat_relief_decompose_to(get(), levels, coarsest.data(), &out_);
    Relief made = Relief(out_);
    detail::check(status, {{"levels", static_cast<double>(levels), 1, 64}});
    return made;
}

inline Relief Relief::copy_levels(const Surface &onto) const {
    bat_relief *out_ = nullptr;
    const bat_status status = bat_relief_copy_levels(get(), onto.get(), &out_);
    Relief made = Relief(out_);
    detail::check(status);
    return made;
}

inline Sweep Curve::sweep(const Curve &profile, const bat_sweep_options *options) const {
    bat_sweep *out_ = nullptr;
    const bat_status status = bat_sweep_create(get(), profile.get(), options, &out_);
    Sweep made = Sweep(out_);
    detail::check(status);
    return made;
}

inline std::array<double, 2> Sweep::domain(bat_direction direction) const {
    std::array<double, 2> domain_{};
    bat_sweep_domain(get(), direction, domain_.data());
    return domain_;
}

inline double Sweep::holonomy() const {
    return bat_sweep_holonomy(get());
}

inline bat_sweep_point Sweep::at(double u, double v) const {
    bat_sweep_point out_{};
    bat_sweep_at(get(), u, v, &out_);
    return out_;
}

inline std::vector<double> Sweep::folds() const {
    size_t count_{};
    std::vector<double> out_;
    size_t room = 0;
    detail::check(bat_sweep_folds(get(), room, out_.data(), &count_));
    room = count_;
    out_.resize(static_cast<std::size_t>(room)*2);
    detail::check(bat_sweep_folds(get(), room, out_.data(), &count_));
    return out_;
}

inline SweepSurfaceResult Sweep::surface(double tolerance) const {
    bat_surface *out_ = nullptr;
    bat_sweep_report report_{};
    const bat_status status = bat_sweep_surface(get(), tolerance, &out_, &report_);
    SweepSurfaceResult made{Surface(out_), report_, status == BAT_OK};
    if (status != BAT_OK && !(status == BAT_TOLERANCE && (out_ != nullptr))) detail::check(status, {{"tolerance", static_cast<double>(tolerance), 0, 1e+75, true}});
    return made;
}

inline CurveRevolveResult Curve::revolve(Numbers origin, Numbers direction, double tolerance, double angle) const {
    detail::exactly("origin", origin.size(), 3);
    detail::exactly("direction", direction.size(), 3);
    bat_surface *out_ = nullptr;
    double max_error_{};
    const bat_status status = bat_surface_revolve(get(), origin.data(), direction.data(), angle, tolerance, &out_, &max_error_);
    CurveRevolveResult made{Surface(out_), max_error_};
    detail::check(status, {{"angle", static_cast<double>(angle), -6.2832, 6.2832}, {"tolerance", static_cast<double>(tolerance), 0, 1e+75, true}});
    return made;
}

inline Surface Surface::blend(bat_side side, const Surface &other, bat_side other_side, const bat_blend_options *options) const {
    bat_surface *out_ = nullptr;
    const bat_status status = bat_surface_blend(get(), side, other.get(), other_side, options, &out_);
    Surface made = Surface(out_);
    detail::check(status);
    return made;
}

inline Surface Surface::blend_to_curve(bat_side side, const Curve &curve, const bat_blend_options *options) const {
    bat_surface *out_ = nullptr;
    const bat_status status = bat_surface_blend_curve(get(), side, curve.get(), options, &out_);
    Surface made = Surface(out_);
    detail::check(status);
    return made;
}

inline SurfaceMatchResult Surface::match(bat_side side, const Surface &other, bat_side other_side, int continuity, double tension) const {
    bat_surface *out_ = nullptr;
    double moved_{};
    const bat_status status = bat_surface_match(get(), side, other.get(), other_side, continuity, tension, &out_, &moved_);
    SurfaceMatchResult made{Surface(out_), moved_};
    detail::check(status, {{"continuity", static_cast<double>(continuity), 0, 3}, {"tension", static_cast<double>(tension), 0, 1e+75, true}});
    return made;
}

inline bat_recipe_stand Curve::stands(const Curve &profile) const {
    return bat_recipe_stands(get(), profile.get());
}

inline Mesh Mesh::copy() const {
    bat_polymesh *out_ = nullptr;
    const bat_status status = bat_polymesh_copy(get(), &out_);
    Mesh made = Mesh(out_);
    detail::check(status);
    return made;
}

inline size_t Mesh::vertex_count() const {
    return bat_polymesh_vertex_count(get());
}

inline Span<const double> Mesh::vertices() const {
    const double *found = bat_polymesh_vertices(get());
    return Span<const double>(found, found == nullptr ? 0 : static_cast<std::size_t>(vertex_count())*3);
}

inline size_t Mesh::face_count() const {
    return bat_polymesh_face_count(get());
}

inline Span<const int> Mesh::face(size_t i) const {
    size_t count_{};
    const int *found = bat_polymesh_face(get(), i, &count_);
    return Span<const int>(found, found == nullptr ? 0 : static_cast<std::size_t>(count_));
}

inline MeshBoxResult Mesh::box() const {
    std::array<double, 3> low_{};
    std::array<double, 3> high_{};
    bat_polymesh_box(get(), low_.data(), high_.data());
    return {low_, high_};
}

inline double Mesh::size() const {
    return bat_polymesh_size(get());
}

inline bool Mesh::is_equal(const Mesh &b) const {
    return bat_polymesh_is_equal(get(), b.get());
}

inline Mesh Mesh::with_vertices(Numbers vertices) const {
    detail::exactly("vertices", vertices.size(), static_cast<std::size_t>(vertex_count())*3);
    bat_polymesh *out_ = nullptr;
    std::size_t wrong_told = std::numeric_limits<std::size_t>::max();
    const bat_status status = bat_polymesh_with(get(), vertices.data(), &out_, &wrong_told);
    Mesh made = Mesh(out_);
    detail::check(status, wrong_told);
    return made;
}

inline size_t Mesh::triangle_count() const {
    return bat_polymesh_triangle_count(get());
}

inline std::vector<int> Mesh::triangles() const {
    std::vector<int> out_(static_cast<std::size_t>(triangle_count())*3);
    const bat_status status = bat_polymesh_triangles(get(), out_.data());
    detail::check(status);
    return out_;
}

inline std::vector<double> Mesh::normals() const {
    std::vector<double> out_(static_cast<std::size_t>(vertex_count())*3);
    bat_polymesh_normals(get(), out_.data());
    return out_;
}

inline ReferenceNearestResult Reference::nearest(Numbers point) const {
    detail::exactly("point", point.size(), 3);
    std::array<double, 3> closest_{};
    double distance_{};
    const bat_status status = bat_reference_nearest(get(), point.data(), closest_.data(), &distance_);
    ReferenceNearestResult made{closest_, distance_};
    detail::check(status);
    return made;
}

inline bat_deviation Curve::deviation(const Reference &reference, double spacing) const {
    bat_deviation out_{};
    const bat_status status = bat_curve_deviation(get(), reference.get(), spacing, &out_);
    detail::check(status, {{"spacing", static_cast<double>(spacing), 0, 1e+75}});
    return out_;
}

inline bat_deviation Surface::deviation(const Reference &reference, double spacing) const {
    bat_deviation out_{};
    const bat_status status = bat_surface_deviation(get(), reference.get(), spacing, &out_);
    detail::check(status, {{"spacing", static_cast<double>(spacing), 0, 1e+75}});
    return out_;
}

inline bat_deviation Mesh::deviation(const Reference &reference, double spacing) const {
    bat_deviation out_{};
    const bat_status status = bat_polymesh_deviation(get(), reference.get(), spacing, &out_);
    detail::check(status, {{"spacing", static_cast<double>(spacing), 0, 1e+75}});
    return out_;
}

inline size_t Binding::count() const {
    return bat_binding_count(get());
}

inline BindingApplyResult Binding::apply(const List<Curve> &curves, Numbers points) const {
    detail::exactly("points", points.size(), 3 * count());
    detail::many("points", points.size(), 3);
    std::vector<double> points_(points.begin(), points.end());
    bat_wire_report report_{};
    std::size_t wrong_told = std::numeric_limits<std::size_t>::max();
    const bat_status status = bat_binding_apply(get(), curves.data(), points_.data(), &report_, &wrong_told);
    BindingApplyResult made{std::move(points_), report_};
    detail::check(status, wrong_told);
    return made;
}

inline std::vector<int> Binding::torn(Span<const int> edges) const {
    size_t count_{};
    std::vector<int> out_;
    size_t room = 0;
    detail::check(bat_binding_torn(get(), detail::many("edges", edges.size(), 2), edges.data(), room, out_.data(), &count_));
    room = count_;
    out_.resize(static_cast<std::size_t>(room)*2);
    detail::check(bat_binding_torn(get(), detail::many("edges", edges.size(), 2), edges.data(), room, out_.data(), &count_));
    return out_;
}

inline size_t Tracks::count() const {
    return bat_tracks_count(get());
}

inline bool Tracks::is_closed(size_t i) const {
    return bat_tracks_is_closed(get(), i);
}

inline size_t Tracks::crossing_count() const {
    return bat_tracks_crossing_count(get());
}

inline const bat_track_point *Tracks::crossing(size_t i) const {
    return bat_tracks_crossing(get(), i);
}

inline bool Tracks::is_given_up() const {
    return bat_tracks_is_given_up(get());
}

inline Tracks Surface::silhouettes(const bat_viewpoint &view) const {
    bat_tracks *out_ = nullptr;
    bat_problem problem{};
    const bat_status status = bat_surface_silhouettes(get(), &view, &out_);
    Tracks made = Tracks(out_);
    if (status != BAT_OK) detail::check(bat_viewpoint_check(&view, &problem), problem);
    detail::check(status);
    return made;
}

inline Tracks Surface::section(Numbers origin, Numbers normal, double tolerance) const {
    detail::exactly("origin", origin.size(), 3);
    detail::exactly("normal", normal.size(), 3);
    bat_tracks *out_ = nullptr;
    const bat_status status = bat_surface_section(get(), origin.data(), normal.data(), tolerance, &out_);
    Tracks made = Tracks(out_);
    detail::check(status, {{"tolerance", static_cast<double>(tolerance), 0, 1e+75}});
    return made;
}

inline Tracks Surface::intersect(const Surface &b, const bat_intersect_options *options) const {
    bat_tracks *out_ = nullptr;
    const bat_status status = bat_surface_intersect(get(), b.get(), options, &out_);
    Tracks made = Tracks(out_);
    detail::check(status);
    return made;
}

inline Curve Tracks::curve(size_t i, double tolerance) const {
    bat_curve *out_ = nullptr;
    const bat_status status = bat_tracks_curve(get(), i, tolerance, &out_);
    Curve made = Curve(out_);
    detail::check(status, {{"tolerance", static_cast<double>(tolerance), 0, 1e+75}});
    return made;
}

inline size_t LineDrawing::count() const {
    return bat_line_drawing_count(get());
}

inline bool LineDrawing::is_whole() const {
    return bat_line_drawing_is_whole(get());
}

inline bat_surface_pick Surface::pick_line(const bat_viewpoint &view, const bat_stroke &marking) const {
    bat_surface_pick out_{};
    bat_problem problem{};
    const bat_status status = bat_surface_pick_line(&view, &marking, get(), &out_);
    if (status != BAT_OK) detail::check(bat_viewpoint_check(&view, &problem), problem);
    detail::check(status);
    return out_;
}

inline SurfaceSketchResult Surface::sketch(bat_direction direction, double at, const bat_viewpoint &view, const bat_stroke &stroke, const bat_surface_sketch_options *options) const {
    bat_surface *out_ = nullptr;
    std::vector<double> weights_(static_cast<std::size_t>(count(direction)));
    bat_surface_sketch_report report_{};
    bat_problem problem{};
    const bat_status status = bat_surface_sketch(get(), direction, at, &view, &stroke, options, &out_, weights_.data(), &report_);
    SurfaceSketchResult made{Surface(out_), std::move(weights_), report_, status == BAT_OK};
    if (status != BAT_OK && !(status == BAT_TOLERANCE && (out_ != nullptr))) if (status != BAT_OK) detail::check(bat_viewpoint_check(&view, &problem), problem);
    detail::check(status, {{"at", static_cast<double>(at), -1e+75, 1e+75}});
    return made;
}

inline Camera Curve::camera(const bat_camera_options *options) const {
    bat_camera *out_ = nullptr;
    const bat_status status = bat_camera_create(get(), options, &out_);
    Camera made = Camera(out_);
    detail::check(status);
    return made;
}

inline Camera Camera::copy() const {
    bat_camera *out_ = nullptr;
    const bat_status status = bat_camera_copy(get(), &out_);
    Camera made = Camera(out_);
    detail::check(status);
    return made;
}

inline Camera Camera::with_path(const Curve &path) const {
    bat_camera *out_ = nullptr;
    const bat_status status = bat_camera_with_path(get(), path.get(), &out_);
    Camera made = Camera(out_);
    detail::check(status);
    return made;
}

inline void Camera::add_level(Numbers knots, Numbers details) {
    const bat_status status = bat_camera_add_level(get(), static_cast<int>(knots.size()), knots.data(), detail::many("details", details.size(), 3), details.data());
    detail::check(status);
}

inline int Camera::levels() const {
    return bat_camera_levels(get());
}

inline std::optional<Curve> Camera::details(int level) const {
    detail::inside("level", level, 1, levels());
    const bat_curve *found = bat_camera_details(get(), level);
    if (found == nullptr) return std::nullopt;
    return Curve(detail::copy_of<Curve>(found, bat_curve_copy));
}

inline double Camera::gain(int level) const {
    detail::inside("level", level, 1, levels());
    return bat_camera_gain(get(), level);
}

inline void Camera::set_gain(int level, double gain) {
    const bat_status status = bat_camera_set_gain(get(), level, gain);
    detail::check(status, {{"gain", static_cast<double>(gain), -1e+75, 1e+75}});
}

inline void Camera::set_muted(int level, bool muted) {
    const bat_status status = bat_camera_set_muted(get(), level, muted);
    detail::check(status);
}

inline bool Camera::is_muted(int level) const {
    detail::inside("level", level, 1, levels());
    return bat_camera_is_muted(get(), level);
}

inline void Camera::add_shake(uint64_t seed, double amount, double rate) {
    const bat_status status = bat_camera_add_shake(get(), seed, amount, rate);
    detail::check(status, {{"amount", static_cast<double>(amount), -1e+75, 1e+75}, {"rate", static_cast<double>(rate), 0, 1e+75, true}});
}

inline bat_camera_shake Camera::shake(int level) const {
    bat_camera_shake out_{};
    const bat_status status = bat_camera_shake_of(get(), level, &out_);
    detail::check(status);
    return out_;
}

inline void Camera::take_levels(const Camera &other) {
    const bat_status status = bat_camera_take_levels(get(), other.get());
    detail::check(status);
}

inline const bat_function *Camera::timing() const {
    return bat_camera_timing(get());
}

inline void Camera::set_timing(double duration, const bat_function *timing) {
    bat_problem problem{};
    const bat_status status = bat_camera_set_timing(get(), duration, timing);
    if (status != BAT_OK && timing != nullptr) detail::check(bat_function_check(timing, &problem), problem);
    detail::check(status, {{"duration", static_cast<double>(duration), 0, 1e+75, true}});
}

inline void Camera::retime(Numbers points) {
    const bat_status status = bat_camera_retime(get(), detail::many("points", points.size(), 2), points.data());
    detail::check(status);
}

inline void Camera::ease(double begin, double end) {
    const bat_status status = bat_camera_ease(get(), begin, end);
    detail::check(status, {{"begin", static_cast<double>(begin), -1e+75, 1e+75}});
}

inline void Camera::turn(int level, double u, Numbers rotation) {
    detail::exactly("rotation", rotation.size(), 4);
    const bat_status status = bat_camera_turn(get(), level, u, rotation.data());
    detail::check(status);
}

inline void Camera::turn_base(Numbers rotation) {
    detail::exactly("rotation", rotation.size(), 4);
    const bat_status status = bat_camera_turn_base(get(), rotation.data());
    detail::check(status);
}

inline Span<const double> Camera::base() const {
    size_t count_{};
    const double *found = bat_camera_base(get(), &count_);
    return Span<const double>(found, found == nullptr ? 0 : static_cast<std::size_t>(count_)*4);
}

inline double Camera::key_place(size_t key) const {
    return bat_camera_key_place(get(), key);
}

inline size_t Camera::add_key(double u) {
    size_t key_{};
    const bat_status status = bat_camera_add_key(get(), u, &key_);
    detail::check(status);
    return key_;
}

inline double Camera::remove_key(size_t key) {
    double change_{};
    const bat_status status = bat_camera_remove_key(get(), key, &change_);
    detail::check(status);
    return change_;
}

inline void Camera::set_fov(double u, double degrees) {
    const bat_status status = bat_camera_set_fov(get(), u, degrees);
    detail::check(status, {{"degrees", static_cast<double>(degrees), -1e+75, 1e+75}});
}

inline Camera Camera::aim(Numbers target, Numbers up) const {
    detail::exactly("target", target.size(), 3);
    detail::exactly("up", up.size(), 3);
    bat_camera *out_ = nullptr;
    const bat_status status = bat_camera_aim(get(), target.data(), up.data(), &out_);
    Camera made = Camera(out_);
    detail::check(status);
    return made;
}

inline Camera Camera::let_go(Numbers first) const {
    if (!first.empty()) detail::exactly("first", first.size(), 3);
    bat_camera *out_ = nullptr;
    const bat_status status = bat_camera_let_go(get(), first.empty() ? nullptr : first.data(), &out_);
    Camera made = Camera(out_);
    detail::check(status);
    return made;
}

inline bat_camera_mode Camera::mode() const {
    return bat_camera_mode_of(get());
}

inline std::optional<Curve> Camera::path() const {
    const bat_curve *found = bat_camera_path(get());
    if (found == nullptr) return std::nullopt;
    return Curve(detail::copy_of<Curve>(found, bat_curve_copy));
}

inline std::array<double, 2> Camera::domain() const {
    std::array<double, 2> domain_{};
    bat_camera_domain(get(), domain_.data());
    return domain_;
}

inline double Camera::length() const {
    return bat_camera_length(get());
}

inline double Camera::duration() const {
    return bat_camera_duration(get());
}

inline double Camera::least_norm() const {
    return bat_camera_least_norm(get());
}

inline std::vector<double> Camera::held() const {
    std::vector<double> out_;
    size_t room = 0;
    room = bat_camera_held(get(), room, out_.data());
    out_.resize(static_cast<std::size_t>(room)*2);
    bat_camera_held(get(), room, out_.data());
    return out_;
}

inline bat_camera_pose Camera::at(double u) const {
    bat_camera_pose out_{};
    bat_camera_at(get(), u, &out_);
    return out_;
}

inline bat_camera_pose Camera::at_time(double time) const {
    bat_camera_pose out_{};
    bat_camera_at_time(get(), time, &out_);
    return out_;
}

inline std::vector<bat_camera_pose> Camera::sample(Numbers times) const {
    std::vector<bat_camera_pose> out_(times.size());
    const bat_status status = bat_camera_sample(get(), times.size(), times.data(), out_.data());
    detail::check(status);
    return out_;
}

inline std::vector<bat_camera_key> Camera::keys(double place, double angle) const {
    size_t count_{};
    bat_camera_key *keys_ = nullptr;
    const bat_status status = bat_camera_keys(get(), place, angle, &count_, &keys_);
    std::vector<bat_camera_key> made = detail::taken(keys_, static_cast<std::size_t>(count_));
    detail::check(status, {{"place", static_cast<double>(place), -1e+75, 1e+75}, {"angle", static_cast<double>(angle), -1e+75, 1e+75}});
    return made;
}

inline Span<const bat_bone> Take::joints() const {
    int count_{};
    const bat_bone *found = bat_take_joints(get(), &count_);
    return Span<const bat_bone>(found, found == nullptr ? 0 : static_cast<std::size_t>(count_));
}

inline Span<const double> Take::values() const {
    size_t frames_{};
    size_t channels_{};
    const double *found = bat_take_values(get(), &frames_, &channels_);
    return Span<const double>(found, found == nullptr ? 0 : static_cast<std::size_t>(frames_)*static_cast<std::size_t>(channels_));
}

inline double Take::frame_time() const {
    return bat_take_frame_time(get());
}

inline std::vector<double> Take::positions(size_t frame) const {
    std::vector<double> out_(joints().size()*3);
    const bat_status status = bat_take_positions(get(), frame, out_.data());
    detail::check(status);
    return out_;
}

inline TakeMotionResult Take::motion(const bat_motion_options *options) const {
    bat_motion *out_ = nullptr;
    bat_motion_report report_{};
    const bat_status status = bat_motion_fit(get(), options, &out_, &report_);
    TakeMotionResult made{Motion(out_), report_};
    detail::check(status);
    return made;
}

inline Motion Motion::copy() const {
    bat_motion *out_ = nullptr;
    const bat_status status = bat_motion_copy(get(), &out_);
    Motion made = Motion(out_);
    detail::check(status);
    return made;
}

inline double Motion::duration() const {
    return bat_motion_duration(get());
}

inline std::vector<double> Motion::positions(double time) const {
    std::vector<double> out_(joints()*3);
    const bat_status status = bat_motion_positions(get(), time, out_.data());
    detail::check(status, {{"time", static_cast<double>(time), -1e+75, 1e+75}});
    return out_;
}

inline int Motion::levels() const {
    return bat_motion_levels(get());
}

inline std::optional<Camera> Motion::joint(int joint) const {
    const bat_camera *found = bat_motion_joint(get(), joint);
    if (found == nullptr) return std::nullopt;
    return Camera(detail::copy_of<Camera>(found, bat_camera_copy));
}

inline std::optional<Shape> Motion::path() const {
    const bat_shape *found = bat_motion_path(get());
    if (found == nullptr) return std::nullopt;
    return Shape(detail::copy_of<Shape>(found, bat_shape_copy));
}

inline void Motion::set_gain(int joint, int level, double gain) {
    const bat_status status = bat_motion_set_gain(get(), joint, level, gain);
    detail::check(status, {{"gain", static_cast<double>(gain), -1e+75, 1e+75}});
}

inline double Motion::angle(int joint, int angle, double time) const {
    double degrees_{};
    const bat_status status = bat_motion_angle(get(), joint, angle, time, &degrees_);
    detail::check(status, {{"angle", static_cast<double>(angle), 0, 2}, {"time", static_cast<double>(time), -1e+75, 1e+75}});
    return degrees_;
}

inline void Motion::redraw(int joint, int angle, int level, Numbers points) {
    const bat_status status = bat_motion_redraw(get(), joint, angle, level, detail::many("points", points.size(), 2), points.data());
    detail::check(status, {{"angle", static_cast<double>(angle), 0, 2}});
}

inline void Motion::bend(const Curve &path) {
    const bat_status status = bat_motion_bend(get(), path.get());
    detail::check(status);
}

inline void Motion::take_style(const Motion &other) {
    const bat_status status = bat_motion_take_style(get(), other.get());
    detail::check(status);
}

inline Take Motion::sample() const {
    bat_take *out_ = nullptr;
    const bat_status status = bat_motion_sample(get(), &out_);
    Take made = Take(out_);
    detail::check(status);
    return made;
}

inline const char *Picture::type() const {
    return bat_picture_type(get());
}

inline uint64_t Picture::digest() const {
    return bat_picture_digest(get());
}

inline std::array<double, 2> Picture::sides() const {
    std::array<double, 2> sides_{};
    bat_picture_sides(get(), sides_.data());
    return sides_;
}

inline Object Object::with_matrix(Numbers matrix) const {
    detail::exactly("matrix", matrix.size(), 6);
    bat_object *out_ = nullptr;
    const bat_status status = bat_object_with_matrix(get(), matrix.data(), &out_);
    Object made = Object(out_);
    detail::check(status);
    return made;
}

inline bool Object::is_foreign() const {
    return bat_object_is_foreign(get());
}

inline Object Object::with_guide(double at) const {
    bat_object *out_ = nullptr;
    const bat_status status = bat_object_with_guide(get(), at, &out_);
    Object made = Object(out_);
    detail::check(status, {{"at", static_cast<double>(at), -1e+75, 1e+75}});
    return made;
}

inline Object Object::with_recipe(const bat_recipe &recipe, const List<Object> &sources) const {
    bat_object *out_ = nullptr;
    const bat_status status = bat_object_with_recipe(get(), &recipe, sources.size(), sources.data(), &out_);
    Object made = Object(out_);
    detail::check(status);
    return made;
}

inline Object Object::with_surface(const Surface &surface) const {
    bat_object *out_ = nullptr;
    const bat_status status = bat_object_with_surface(get(), surface.get(), &out_);
    Object made = Object(out_);
    detail::check(status);
    return made;
}

inline Object Object::bind(Span<const bat_wire> wires, const List<Object> &curves, const bat_wire_options *options) const {
    detail::exactly("curves", curves.size(), wires.size());
    bat_object *out_ = nullptr;
    const bat_status status = bat_object_bind(get(), wires.size(), wires.data(), curves.data(), nullptr, options, &out_);
    Object made = Object(out_);
    detail::check(status);
    return made;
}

inline Object Object::unbind(bool revert) const {
    bat_object *out_ = nullptr;
    const bat_status status = bat_object_unbind(get(), revert, &out_);
    Object made = Object(out_);
    detail::check(status);
    return made;
}

inline Object Object::with_relief(const Relief &relief) const {
    bat_object *out_ = nullptr;
    const bat_status status = bat_object_with_relief(get(), relief.get(), &out_);
    Object made = Object(out_);
    detail::check(status);
    return made;
}

inline Object Object::with_camera(const Camera &camera, bat_id follows) const {
    bat_object *out_ = nullptr;
    const bat_status status = bat_object_with_camera(get(), camera.get(), follows, &out_);
    Object made = Object(out_);
    detail::check(status, {{"follows", static_cast<double>(follows), 0, 2147483647}});
    return made;
}

inline Object Object::with_motion(const Motion &motion) const {
    bat_object *out_ = nullptr;
    const bat_status status = bat_object_with_motion(get(), motion.get(), &out_);
    Object made = Object(out_);
    detail::check(status);
    return made;
}

inline Object Object::at_time(double seconds) const {
    bat_object *out_ = nullptr;
    const bat_status status = bat_object_at_time(get(), seconds, &out_);
    Object made = Object(out_);
    detail::check(status, {{"seconds", static_cast<double>(seconds), -1e+75, 1e+75}});
    return made;
}

inline Object Object::with_curves(const List<Curve> &curves) const {
    const auto curves_kept = curves.kept(bat_curve_copy);
    bat_object *out_ = nullptr;
    const bat_status status = bat_object_with_curves(get(), static_cast<int>(curves.size()), curves_kept.data(), &out_);
    Object made = Object(out_);
    detail::check(status);
    return made;
}

inline Object Object::with_parent(bat_id parent) const {
    bat_object *out_ = nullptr;
    const bat_status status = bat_object_with_parent(get(), parent, &out_);
    Object made = Object(out_);
    detail::check(status, {{"parent", static_cast<double>(parent), 0, 2147483647}});
    return made;
}

inline Object Object::with_name(const std::string &name) const {
    bat_object *out_ = nullptr;
    const bat_status status = bat_object_with_name(get(), name.c_str(), &out_);
    Object made = Object(out_);
    detail::check(status);
    return made;
}

inline Object Object::with_state(bool hidden, bool locked) const {
    bat_object *out_ = nullptr;
    const bat_status status = bat_object_with_state(get(), hidden, locked, &out_);
    Object made = Object(out_);
    detail::check(status);
    return made;
}

inline Object Object::with_id(bat_id id) const {
    bat_object *out_ = nullptr;
    const bat_status status = bat_object_with_id(get(), id, &out_);
    Object made = Object(out_);
    detail::check(status, {{"id", static_cast<double>(id), 1, 2147483647}});
    return made;
}

inline Object Object::with_curve(int index, const Curve &curve) const {
    bat_object *out_ = nullptr;
    const bat_status status = bat_object_with_curve(get(), index, detail::copy_of<Curve>(curve.get(), bat_curve_copy), &out_);
    Object made = Object(out_);
    detail::check(status);
    return made;
}

inline Object Object::with_style(const bat_style &style) const {
    bat_object *out_ = nullptr;
    bat_problem problem{};
    const bat_status status = bat_object_with_style(get(), &style, &out_);
    Object made = Object(out_);
    if (status != BAT_OK) detail::check(bat_style_check(&style, &problem), problem);
    detail::check(status);
    return made;
}

inline Object Object::with_shape(int index, const Shape &shape) const {
    bat_object *out_ = nullptr;
    const bat_status status = bat_object_with_shape(get(), index, detail::copy_of<Shape>(shape.get(), bat_shape_copy), &out_);
    Object made = Object(out_);
    detail::check(status);
    return made;
}

inline Object Object::with_spline(const bat_spline &spline) const {
    bat_object *out_ = nullptr;
    const bat_status status = bat_object_with_spline(get(), &spline, &out_);
    Object made = Object(out_);
    detail::check(status);
    return made;
}

inline Object Object::to_path() const {
    bat_object *out_ = nullptr;
    const bat_status status = bat_object_to_path(get(), &out_);
    Object made = Object(out_);
    detail::check(status);
    return made;
}

inline bat_id Object::id() const {
    return bat_object_id(get());
}

inline bat_kind Object::kind() const {
    return bat_object_kind(get());
}

inline const char *Object::name() const {
    return bat_object_name(get());
}

inline const bat_style *Object::style() const {
    return bat_object_style(get());
}

inline int Object::curve_count() const {
    return bat_object_curve_count(get());
}

inline bool Object::is_made_of_curves() const {
    return bat_object_is_made_of_curves(get());
}

inline std::optional<Curve> Object::curve(int index) const {
    const bat_curve *found = bat_object_curve(get(), index);
    if (found == nullptr) return std::nullopt;
    return Curve(detail::copy_of<Curve>(found, bat_curve_copy));
}

inline const bat_tangents_options *Object::spline_options() const {
    return bat_object_spline_options(get());
}

inline std::optional<Shape> Object::shape(int index) const {
    const bat_shape *found = bat_object_shape(get(), index);
    if (found == nullptr) return std::nullopt;
    return Shape(detail::copy_of<Shape>(found, bat_shape_copy));
}

inline std::optional<Picture> Object::picture() const {
    const bat_picture *found = bat_object_picture(get());
    if (found == nullptr) return std::nullopt;
    bat_picture_retain(const_cast<bat_picture *>(found));
    return Picture(const_cast<bat_picture *>(found));
}

inline Span<const double> Object::matrix() const {
    const double *found = bat_object_matrix(get());
    return Span<const double>(found, found == nullptr ? 0 : 6);
}

inline bool Object::is_group() const {
    return bat_object_is_group(get());
}

inline bool Object::is_drawn() const {
    return bat_object_is_drawn(get());
}

inline std::optional<Surface> Object::surface() const {
    const bat_surface *found = bat_object_surface(get());
    if (found == nullptr) return std::nullopt;
    return Surface(detail::copy_of<Surface>(found, bat_surface_copy));
}

inline std::optional<Mesh> Object::mesh() const {
    const bat_polymesh *found = bat_object_mesh(get());
    if (found == nullptr) return std::nullopt;
    return Mesh(detail::copy_of<Mesh>(found, bat_polymesh_copy));
}

inline std::optional<Relief> Object::relief() const {
    const bat_relief *found = bat_object_relief(get());
    if (found == nullptr) return std::nullopt;
    return Relief(detail::copy_of<Relief>(found, bat_relief_copy));
}

inline const bat_recipe *Object::recipe() const {
    return bat_object_recipe(get());
}

inline std::optional<Camera> Object::camera() const {
    const bat_camera *found = bat_object_camera(get());
    if (found == nullptr) return std::nullopt;
    return Camera(detail::copy_of<Camera>(found, bat_camera_copy));
}

inline std::optional<Motion> Object::motion() const {
    const bat_motion *found = bat_object_motion(get(), nullptr);
    if (found == nullptr) return std::nullopt;
    return Motion(detail::copy_of<Motion>(found, bat_motion_copy));
}

inline bat_id Object::followed() const {
    return bat_object_followed(get());
}

inline Span<const double> Object::plane() const {
    const double *found = bat_object_plane(get());
    return Span<const double>(found, found == nullptr ? 0 : 9);
}

inline const bat_viewpoint *Object::view() const {
    return bat_object_view(get());
}

inline bat_id Object::parent() const {
    return bat_object_parent(get());
}

inline bool Object::is_hidden() const {
    return bat_object_is_hidden(get());
}

inline bool Object::is_locked() const {
    return bat_object_is_locked(get());
}

inline std::array<double, 4> Object::bounds() const {
    std::array<double, 4> box_{};
    bat_object_bounds(get(), box_.data());
    return box_;
}

inline Object Object::with_paint(const bat_paint &paint) const {
    bat_object *out_ = nullptr;
    bat_problem problem{};
    const bat_status status = bat_object_with_paint(get(), &paint, &out_);
    Object made = Object(out_);
    if (status != BAT_OK) detail::check(bat_paint_check(&paint, &problem), problem);
    detail::check(status);
    return made;
}

inline const bat_paint *Object::paint() const {
    return bat_object_paint(get());
}

inline std::vector<double> Object::cover(int curve) const {
    size_t cubics_{};
    double *points_ = nullptr;
    const bat_status status = bat_object_cover(get(), curve, &cubics_, &points_);
    std::vector<double> made = detail::taken(points_, static_cast<std::size_t>(cubics_)*4*2);
    detail::check(status);
    return made;
}

inline Document Document::copy() const {
    bat_document *out_ = nullptr;
    const bat_status status = bat_document_copy(get(), &out_);
    Document made = Document(out_);
    detail::check(status);
    return made;
}

inline int Document::count() const {
    return bat_document_count(get());
}

inline std::optional<Object> Document::at(int index) const {
    const bat_object *found = bat_document_at(get(), index);
    if (found == nullptr) return std::nullopt;
    bat_object_retain(const_cast<bat_object *>(found));
    return Object(const_cast<bat_object *>(found));
}

inline int Document::find(bat_id id) const {
    return bat_document_find(get(), id);
}

inline bat_id Document::new_id() {
    return bat_document_new_id(get());
}

inline void Document::insert(int index, const Object &object) {
    const bat_status status = bat_document_insert(get(), index, object.get());
    detail::check(status);
}

inline void Document::replace(int index, const Object &object) {
    const bat_status status = bat_document_replace(get(), index, object.get());
    detail::check(status);
}

inline void Document::remove(int index) {
    const bat_status status = bat_document_remove(get(), index);
    detail::check(status);
}

inline int Document::end(int index) const {
    return bat_document_end(get(), index);
}

inline std::array<double, 4> Document::page() const {
    std::array<double, 4> page_{};
    bat_document_page(get(), page_.data());
    return page_;
}

inline void Document::set_page(Numbers page) {
    detail::exactly("page", page.size(), 4);
    const bat_status status = bat_document_set_page(get(), page.data());
    detail::check(status);
}

inline std::array<double, 4> Document::bounds() const {
    std::array<double, 4> box_{};
    bat_document_bounds(get(), box_.data());
    return box_;
}

inline double Document::scale() const {
    return bat_document_scale(get());
}

inline bat_unit Document::unit() const {
    return bat_document_unit(get());
}

inline void Document::set_scale(double millimetres, bat_unit unit) {
    const bat_status status = bat_document_set_scale(get(), millimetres, unit);
    detail::check(status, {{"millimetres", static_cast<double>(millimetres), 1e-12, 1000000000000.0}});
}

inline const char *Document::check() const {
    return bat_document_check(get());
}

inline uint64_t Document::digest() const {
    return bat_document_digest(get());
}

inline std::string Document::write() const {
    char *text_ = nullptr;
    size_t size_{};
    const bat_status status = bat_document_write(get(), &text_, &size_);
    std::string made = detail::taken_text(text_, size_);
    detail::check(status);
    return made;
}

inline std::string Curve::write() const {
    char *text_ = nullptr;
    size_t size_{};
    const bat_status status = bat_curve_write(get(), &text_, &size_);
    std::string made = detail::taken_text(text_, size_);
    detail::check(status);
    return made;
}

inline std::string Surface::write() const {
    char *text_ = nullptr;
    size_t size_{};
    const bat_status status = bat_surface_write(get(), &text_, &size_);
    std::string made = detail::taken_text(text_, size_);
    detail::check(status);
    return made;
}

inline std::string Mesh::write() const {
    char *text_ = nullptr;
    size_t size_{};
    const bat_status status = bat_polymesh_write(get(), &text_, &size_);
    std::string made = detail::taken_text(text_, size_);
    detail::check(status);
    return made;
}

inline std::string Document::to_dxf(double arcs) const {
    char *text_ = nullptr;
    size_t size_{};
    const bat_status status = bat_dxf_write(get(), arcs, &text_, &size_);
    std::string made = detail::taken_text(text_, size_);
    detail::check(status, {{"arcs", static_cast<double>(arcs), 0, 1e+75, true}});
    return made;
}

inline std::string Document::to_glif(bool extremes) const {
    char *text_ = nullptr;
    size_t size_{};
    const bat_status status = bat_glif_write(get(), extremes, &text_, &size_);
    std::string made = detail::taken_text(text_, size_);
    detail::check(status);
    return made;
}

inline std::string Document::replace_glif(std::string_view glyph, bool extremes) const {
    char *text_ = nullptr;
    size_t size_{};
    bat_problem problem_told{};
    const bat_status status = bat_glif_replace(glyph.data(), glyph.size(), get(), extremes, &text_, &size_, &problem_told);
    std::string made = detail::taken_text(text_, size_);
    detail::check(status, problem_told);
    return made;
}

inline std::string Document::to_gcode(const bat_gcode_options *options) const {
    char *text_ = nullptr;
    size_t size_{};
    const bat_status status = bat_gcode_write(get(), options, &text_, &size_);
    std::string made = detail::taken_text(text_, size_);
    detail::check(status);
    return made;
}

inline std::string Camera::to_gltf(double place, double angle) const {
    char *bytes_ = nullptr;
    size_t size_{};
    const bat_status status = bat_gltf_write_move(get(), place, angle, &bytes_, &size_);
    std::string made = detail::taken_text(bytes_, size_);
    detail::check(status, {{"place", static_cast<double>(place), -1e+75, 1e+75}, {"angle", static_cast<double>(angle), -1e+75, 1e+75}});
    return made;
}

inline std::string Camera::to_gltf_scene(const bat_model &scene, double place, double angle) const {
    char *bytes_ = nullptr;
    size_t size_{};
    const bat_status status = bat_gltf_write_scene(get(), &scene, place, angle, &bytes_, &size_);
    std::string made = detail::taken_text(bytes_, size_);
    detail::check(status, {{"place", static_cast<double>(place), -1e+75, 1e+75}, {"angle", static_cast<double>(angle), -1e+75, 1e+75}});
    return made;
}

inline std::string Take::to_bvh() const {
    char *bytes_ = nullptr;
    size_t size_{};
    const bat_status status = bat_bvh_write(get(), &bytes_, &size_);
    std::string made = detail::taken_text(bytes_, size_);
    detail::check(status);
    return made;
}

inline std::string Motion::write(const bat_motion_report &report) const {
    char *text_ = nullptr;
    size_t size_{};
    const bat_status status = bat_motion_write(get(), &report, &text_, &size_);
    std::string made = detail::taken_text(text_, size_);
    detail::check(status);
    return made;
}

inline std::string Camera::write() const {
    char *text_ = nullptr;
    size_t size_{};
    const bat_status status = bat_camera_write(get(), &text_, &size_);
    std::string made = detail::taken_text(text_, size_);
    detail::check(status);
    return made;
}

inline std::string Shape::write() const {
    char *text_ = nullptr;
    size_t size_{};
    const bat_status status = bat_shape_write(get(), &text_, &size_);
    std::string made = detail::taken_text(text_, size_);
    detail::check(status);
    return made;
}

inline void Shape::edit(std::string_view text) {
    bat_problem problem_told{};
    const bat_status status = bat_shape_edit(get(), text.data(), text.size(), &problem_told);
    detail::check(status, problem_told);
}

inline std::string Relief::write() const {
    char *text_ = nullptr;
    size_t size_{};
    const bat_status status = bat_relief_write(get(), &text_, &size_);
    std::string made = detail::taken_text(text_, size_);
    detail::check(status);
    return made;
}

inline std::string Document::to_svg(bool native) const {
    char *text_ = nullptr;
    size_t size_{};
    const bat_status status = bat_svg_write(get(), native, &text_, &size_);
    std::string made = detail::taken_text(text_, size_);
    detail::check(status);
    return made;
}

inline std::string Document::to_svg_within(double precision, bool native) const {
    char *text_ = nullptr;
    size_t size_{};
    const bat_status status = bat_svg_write_within(get(), native, precision, &text_, &size_);
    std::string made = detail::taken_text(text_, size_);
    detail::check(status, {{"precision", static_cast<double>(precision), 0, 1e+75, true}});
    return made;
}

inline std::string Document::to_svg_kept(bool native, double precision) const {
    char *text_ = nullptr;
    size_t size_{};
    const bat_status status = bat_svg_write_kept(get(), native, precision, &text_, &size_);
    std::string made = detail::taken_text(text_, size_);
    detail::check(status, {{"precision", static_cast<double>(precision), 0, 1e+75, true}});
    return made;
}

inline bool Document::is_kept() const {
    return bat_svg_is_kept(get());
}

[[nodiscard]] inline Curve curve(Numbers points, Numbers knots, int dimension = 2, int degree = 3, bool closed = false) {
    detail::inside("degree", degree, 1, 7);
    bat_curve *out_ = nullptr;
    bat_problem problem{};
    const bat_status status = bat_curve_create(dimension, degree, closed, detail::many("points", points.size(), static_cast<std::size_t>(dimension)), points.data(), static_cast<int>(knots.size()), knots.data(), &out_);
    Curve made = Curve(out_);
    if (status != BAT_OK) detail::check(bat_curve_check(dimension, degree, closed, detail::many("points", points.size(), static_cast<std::size_t>(dimension)), points.data(), static_cast<int>(knots.size()), knots.data(), &problem), problem);
    detail::check(status, {{"degree", static_cast<double>(degree), 1, 7}});
    return made;
}

[[nodiscard]] inline Curve clamped(Numbers points, int dimension = 2, int degree = 3) {
    detail::inside("degree", degree, 1, 7);
    bat_curve *out_ = nullptr;
    bat_problem problem{};
    const bat_status status = bat_curve_create_clamped(dimension, degree, detail::many("points", points.size(), static_cast<std::size_t>(dimension)), points.data(), &out_);
    Curve made = Curve(out_);
    if (status != BAT_OK) detail::check(bat_curve_clamped_check(dimension, degree, detail::many("points", points.size(), static_cast<std::size_t>(dimension)), points.data(), &problem), problem);
    detail::check(status, {{"degree", static_cast<double>(degree), 1, 7}});
    return made;
}

[[nodiscard]] inline FromBezierResult from_bezier(Numbers points, int dimension = 2, int degree = 3, bool closed = false, double corner = 0.05, double tolerance = 0) {
    detail::inside("degree", degree, 1, 7);
    detail::many("points", points.size(), static_cast<std::size_t>(dimension));
    bat_curve *out_ = nullptr;
    double error_{};
    const bat_status status = bat_curve_from_bezier(dimension, degree, closed, static_cast<int>((detail::many("points", points.size(), static_cast<std::size_t>(dimension))-1)/static_cast<std::size_t>(degree)), points.data(), corner, tolerance, &out_, &error_);
    FromBezierResult made{Curve(out_), error_};
    detail::check(status, {{"degree", static_cast<double>(degree), 1, 7}, {"corner", static_cast<double>(corner), 0, 1e+75}, {"tolerance", static_cast<double>(tolerance), 0, 1e+75}});
    return made;
}

[[nodiscard]] inline std::vector<Curve> combine(bat_region_operation operation, Span<const bat_region> regions, double tolerance) {
    size_t count_{};
    bat_curve **curves_ = nullptr;
    const bat_status status = bat_regions_combine(operation, regions.size(), regions.data(), tolerance, &count_, &curves_);
    std::vector<Curve> made = detail::taken_objects<Curve>(curves_, static_cast<std::size_t>(count_));
    detail::check(status, {{"tolerance", static_cast<double>(tolerance), 0, 1e+75, true}});
    return made;
}

[[nodiscard]] inline FitResult fit(Numbers points, const bat_fit_options *options = nullptr, int dimension = 2) {
    bat_curve *out_ = nullptr;
    bat_fit_report report_{};
    const bat_status status = bat_fit(dimension, detail::many("points", points.size(), static_cast<std::size_t>(dimension)), points.data(), options, &out_, &report_);
    FitResult made{Curve(out_), report_, status == BAT_OK};
    if (status != BAT_OK && !(status == BAT_TOLERANCE && (out_ != nullptr))) detail::check(status);
    return made;
}

[[nodiscard]] inline Curve interpolate(Numbers points, int dimension = 2, bool closed = false, Numbers ends = {}) {
    if (!ends.empty()) detail::exactly("ends", ends.size(), 2*static_cast<std::size_t>(dimension));
    bat_curve *out_ = nullptr;
    const bat_status status = bat_interpolate(dimension, closed, detail::many("points", points.size(), static_cast<std::size_t>(dimension)), points.data(), ends.empty() ? nullptr : ends.data(), &out_);
    Curve made = Curve(out_);
    detail::check(status);
    return made;
}

[[nodiscard]] inline FitWithinResult fit_within(Numbers points, const bat_fit_options *options = nullptr, int dimension = 2) {
    bat_curve *out_ = nullptr;
    bat_fit_report report_{};
    const bat_status status = bat_fit_within(dimension, detail::many("points", points.size(), static_cast<std::size_t>(dimension)), points.data(), options, &out_, &report_);
    FitWithinResult made{Curve(out_), report_};
    detail::check(status);
    return made;
}

[[nodiscard]] inline SketchResult sketch(const bat_stroke &stroke, const bat_sketch_options *options = nullptr, bool force_closed = false) {
    bat_curve *out_ = nullptr;
    bat_sketch_report report_{};
    const bat_status status = bat_sketch_new(&stroke, force_closed, options, &out_, &report_);
    SketchResult made{Curve(out_), report_};
    detail::check(status);
    return made;
}

[[nodiscard]] inline LiveSketch live(const bat_sketch_options *options = nullptr, int dimension = 2, bat_sketch_kind kind = static_cast<bat_sketch_kind>(1)) {
    bat_sketch_live *out_ = nullptr;
    const bat_status status = bat_sketch_live_begin(nullptr, dimension, kind, options, &out_);
    LiveSketch made = LiveSketch(out_);
    detail::check(status);
    return made;
}

[[nodiscard]] inline double tangents_k(Numbers c0, Numbers c1, Numbers direction, int dimension = 2) {
    detail::exactly("c0", c0.size(), static_cast<std::size_t>(dimension));
    detail::exactly("c1", c1.size(), static_cast<std::size_t>(dimension));
    detail::exactly("direction", direction.size(), static_cast<std::size_t>(dimension));
    return bat_tangents_k(dimension, c0.data(), c1.data(), direction.data());
}

[[nodiscard]] inline SplineResult spline(const bat_spline &spline, const bat_tangents_options *options = nullptr) {
    std::vector<bat_joint> joints_(spline.count);
    int segments_{};
    double *bezier_ = nullptr;
    bat_curve *out_ = nullptr;
    const bat_status status = bat_tangents(&spline, options, joints_.data(), &segments_, &bezier_, &out_);
    SplineResult made{std::move(joints_), detail::taken(bezier_, static_cast<std::size_t>(segments_)*4*static_cast<std::size_t>(spline.dimension)), Curve(out_)};
    detail::check(status);
    return made;
}

[[nodiscard]] inline Shape shape_from_spline(const bat_spline &spline, const bat_tangents_options *options = nullptr, const bat_shape_options *shape_options = nullptr) {
    bat_shape *out_ = nullptr;
    const bat_status status = bat_shape_from_spline(&spline, options, shape_options, &out_);
    Shape made = Shape(out_);
    detail::check(status);
    return made;
}

inline void check_function(const bat_function &function) {
    bat_problem problem_told{};
    const bat_status status = bat_function_check(&function, &problem_told);
    detail::check(status, problem_told);
}

[[nodiscard]] inline std::array<double, 3> function_at(const bat_function &function, double x) {
    std::array<double, 3> out_{};
    bat_problem refused{};
    detail::check(bat_function_check(&function, &refused), refused);
    bat_function_eval(&function, x, out_.data());
    return out_;
}

[[nodiscard]] inline std::vector<Curve> offset_region(const bat_region &region, double distance, double tolerance, bat_join join = static_cast<bat_join>(1), double miter_limit = 4.0, double corner = 0.05) {
    size_t count_{};
    bat_curve **curves_ = nullptr;
    const bat_status status = bat_region_offset(&region, distance, join, miter_limit, tolerance, corner, &count_, &curves_);
    std::vector<Curve> made = detail::taken_objects<Curve>(curves_, static_cast<std::size_t>(count_));
    detail::check(status, {{"distance", static_cast<double>(distance), -1e+75, 1e+75}, {"miter_limit", static_cast<double>(miter_limit), 1, 1e+75}, {"tolerance", static_cast<double>(tolerance), 0, 1e+75, true}, {"corner", static_cast<double>(corner), 0, 1e+75}});
    return made;
}

inline void check_widths(const bat_width_profile &profile) {
    bat_problem problem_told{};
    const bat_status status = bat_width_check(&profile, &problem_told);
    detail::check(status, problem_told);
}

[[nodiscard]] inline std::array<double, 2> width_at(const bat_width_profile &profile, double at, bool closed = false) {
    std::array<double, 2> out_{};
    bat_problem refused{};
    detail::check(bat_width_check(&profile, &refused), refused);
    bat_width_eval(&profile, closed, at, out_.data());
    return out_;
}

[[nodiscard]] inline bool width_is_even(const bat_width_profile &profile) {
    bat_problem refused{};
    detail::check(bat_width_check(&profile, &refused), refused);
    return bat_width_is_even(&profile);
}

[[nodiscard]] inline Surface surface(Span<const int> degree, Span<const bool> closed, Span<const size_t> count, Numbers points, Span<const int> knot_count, Numbers u_knots, Numbers v_knots) {
    detail::exactly("degree", degree.size(), 2);
    detail::exactly("closed", closed.size(), 2);
    detail::exactly("count", count.size(), 2);
    detail::many("points", points.size(), 3);
    detail::exactly("knot_count", knot_count.size(), 2);
    bat_surface *out_ = nullptr;
    bat_problem problem{};
    const bat_status status = bat_surface_create(degree.data(), closed.data(), count.data(), points.data(), knot_count.data(), u_knots.data(), v_knots.data(), &out_);
    Surface made = Surface(out_);
    if (status != BAT_OK) detail::check(bat_surface_check(degree.data(), closed.data(), count.data(), points.data(), knot_count.data(), u_knots.data(), v_knots.data(), &problem), problem);
    detail::check(status);
    return made;
}

[[nodiscard]] inline CoonsResult coons(const List<Curve> &sides, double within = 1e-9) {
    detail::exactly("sides", sides.size(), 4);
    bat_surface *out_ = nullptr;
    std::array<double, 4> apart_{};
    const bat_status status = bat_surface_coons(sides.data(), within, &out_, apart_.data());
    CoonsResult made{Surface(out_), apart_};
    detail::check(status, {{"within", static_cast<double>(within), 0, 1e+75}});
    return made;
}

[[nodiscard]] inline LoftResult loft(const List<Curve> &sections) {
    bat_surface *out_ = nullptr;
    std::vector<double> v_(sections.size());
    const bat_status status = bat_surface_loft(sections.size(), sections.data(), &out_, v_.data());
    LoftResult made{Surface(out_), std::move(v_)};
    detail::check(status);
    return made;
}

inline void check_recipe(const bat_recipe &recipe, size_t count) {
    bat_problem problem_told{};
    const bat_status status = bat_recipe_check(&recipe, count, &problem_told);
    detail::check(status, problem_told);
}

[[nodiscard]] inline RecipeSurfaceResult recipe_surface(const bat_recipe &recipe, const List<Curve> &curves) {
    bat_surface *out_ = nullptr;
    bat_recipe_report report_{};
    const bat_status status = bat_recipe_surface(&recipe, curves.size(), curves.data(), &out_, &report_);
    RecipeSurfaceResult made{Surface(out_), report_, status == BAT_OK};
    if (status != BAT_OK && !(status == BAT_TOLERANCE && (out_ != nullptr))) detail::check(status);
    return made;
}

[[nodiscard]] inline Mesh mesh(Numbers vertices, Span<const int> sizes, Span<const int> corners) {
    bat_polymesh *out_ = nullptr;
    std::size_t wrong_told = std::numeric_limits<std::size_t>::max();
    bat_problem problem{};
    const bat_status status = bat_polymesh_create(detail::many("vertices", vertices.size(), 3), vertices.data(), sizes.size(), sizes.data(), corners.data(), &out_, &wrong_told);
    Mesh made = Mesh(out_);
    if (status != BAT_OK) detail::check(bat_polymesh_check(detail::many("vertices", vertices.size(), 3), vertices.data(), sizes.size(), sizes.data(), corners.data(), &problem), problem);
    detail::check(status, wrong_told);
    return made;
}

[[nodiscard]] inline Reference reference(const List<Curve> &curves = {}, const List<Surface> &surfaces = {}, const List<Mesh> &meshes = {}) {
    bat_reference *out_ = nullptr;
    const bat_status status = bat_reference_create(curves.size(), curves.data(), surfaces.size(), surfaces.data(), meshes.size(), meshes.data(), &out_);
    Reference made = Reference(out_);
    detail::check(status);
    return made;
}

[[nodiscard]] inline Binding bind(Span<const bat_wire> wires, Numbers points, const bat_wire_options *options = nullptr) {
    bat_binding *out_ = nullptr;
    std::size_t wrong_told = std::numeric_limits<std::size_t>::max();
    const bat_status status = bat_wires_bind(wires.size(), wires.data(), detail::many("points", points.size(), 3), points.data(), options, &out_, &wrong_told);
    Binding made = Binding(out_);
    detail::check(status, wrong_told);
    return made;
}

[[nodiscard]] inline LineDrawing line_drawing(const bat_viewpoint &view, const bat_line_scene &scene) {
    bat_line_drawing *out_ = nullptr;
    bat_problem problem{};
    const bat_status status = bat_line_drawing_create(&view, &scene, &out_);
    LineDrawing made = LineDrawing(out_);
    if (status != BAT_OK) detail::check(bat_viewpoint_check(&view, &problem), problem);
    detail::check(status);
    return made;
}

inline void check_view(const bat_viewpoint &view) {
    bat_problem problem_told{};
    const bat_status status = bat_viewpoint_check(&view, &problem_told);
    detail::check(status, problem_told);
}

[[nodiscard]] inline ViewRayResult view_ray(const bat_viewpoint &view, Numbers pixel) {
    detail::exactly("pixel", pixel.size(), 2);
    std::array<double, 3> origin_{};
    std::array<double, 3> direction_{};
    bat_problem problem{};
    const bat_status status = bat_viewpoint_ray(&view, pixel.data(), origin_.data(), direction_.data());
    ViewRayResult made{origin_, direction_};
    if (status != BAT_OK) detail::check(bat_viewpoint_check(&view, &problem), problem);
    detail::check(status);
    return made;
}

[[nodiscard]] inline ViewProjectResult view_project(const bat_viewpoint &view, Numbers point) {
    detail::exactly("point", point.size(), 3);
    std::array<double, 2> pixel_{};
    double depth_{};
    bat_problem problem{};
    const bat_status status = bat_viewpoint_project(&view, point.data(), pixel_.data(), &depth_);
    ViewProjectResult made{pixel_, depth_};
    if (status != BAT_OK) detail::check(bat_viewpoint_check(&view, &problem), problem);
    detail::check(status);
    return made;
}

[[nodiscard]] inline CastResult cast(const bat_viewpoint &view, const bat_stroke &stroke, const bat_canvas &canvas) {
    std::vector<bat_cast_point> out_(stroke.count);
    size_t landed_{};
    bat_problem problem{};
    const bat_status status = bat_cast(&view, &stroke, &canvas, out_.data(), &landed_);
    CastResult made{std::move(out_), landed_};
    if (status != BAT_OK) detail::check(bat_viewpoint_check(&view, &problem), problem);
    detail::check(status);
    return made;
}

[[nodiscard]] inline bat_viewpoint pose_view(const bat_camera_pose &pose, double distance, Numbers size) {
    detail::exactly("size", size.size(), 2);
    bat_viewpoint out_{};
    const bat_status status = bat_camera_view(&pose, distance, size.data(), &out_);
    detail::check(status, {{"distance", static_cast<double>(distance), 0, 1e+75, true}});
    return out_;
}

[[nodiscard]] inline std::vector<double> ascending(Numbers values) {
    std::vector<double> values_(values.begin(), values.end());
    const bat_status status = bat_pool_ascending(values.size(), values_.data());
    detail::check(status);
    return values_;
}

[[nodiscard]] inline Take take(Span<const bat_bone> joints, size_t frames, double frame_time, Numbers values) {
    bat_take *out_ = nullptr;
    bat_problem problem{};
    const bat_status status = bat_take_create(static_cast<int>(joints.size()), joints.data(), frames, frame_time, values.data(), &out_);
    Take made = Take(out_);
    if (status != BAT_OK) detail::check(bat_take_check(static_cast<int>(joints.size()), joints.data(), frames, frame_time, values.data(), &problem), problem);
    detail::check(status, {{"frame_time", static_cast<double>(frame_time), 0, 1000000000.0, true}});
    return made;
}

[[nodiscard]] inline Picture picture(std::string_view bytes) {
    bat_picture *out_ = nullptr;
    bat_problem problem{};
    const bat_status status = bat_picture_create(bytes.data(), bytes.size(), &out_);
    Picture made = Picture(out_);
    if (status != BAT_OK) detail::check(bat_picture_check(bytes.data(), bytes.size(), &problem), problem);
    detail::check(status);
    return made;
}

[[nodiscard]] inline Object path_object(const List<Curve> &curves, bat_id id = 1, const std::string &name = {}, const bat_style *style = nullptr) {
    const auto curves_kept = curves.kept(bat_curve_copy);
    bat_object *out_ = nullptr;
    bat_problem problem{};
    const bat_status status = bat_object_create_path(id, name.c_str(), style, static_cast<int>(curves.size()), curves_kept.data(), &out_);
    Object made = Object(out_);
    if (status != BAT_OK && style != nullptr) detail::check(bat_style_check(style, &problem), problem);
    detail::check(status, {{"id", static_cast<double>(id), 1, 2147483647}});
    return made;
}

[[nodiscard]] inline Object spline_object(const bat_spline &spline, const bat_tangents_options *options = nullptr, bat_id id = 1, const std::string &name = {}, const bat_style *style = nullptr) {
    bat_object *out_ = nullptr;
    bat_problem problem{};
    const bat_status status = bat_object_create_spline(id, name.c_str(), style, &spline, options, &out_);
    Object made = Object(out_);
    if (status != BAT_OK && style != nullptr) detail::check(bat_style_check(style, &problem), problem);
    detail::check(status, {{"id", static_cast<double>(id), 1, 2147483647}});
    return made;
}

[[nodiscard]] inline Object group_object(bat_id id = 1, const std::string &name = {}, bool layer = false) {
    bat_object *out_ = nullptr;
    const bat_status status = bat_object_create_group(id, name.c_str(), layer, &out_);
    Object made = Object(out_);
    detail::check(status, {{"id", static_cast<double>(id), 1, 2147483647}});
    return made;
}

[[nodiscard]] inline Object image_object(const Picture &picture, Numbers matrix, bat_id id = 1, const std::string &name = {}, double opacity = 1.0) {
    detail::exactly("matrix", matrix.size(), 6);
    bat_object *out_ = nullptr;
    const bat_status status = bat_object_create_image(id, name.c_str(), picture.get(), matrix.data(), opacity, &out_);
    Object made = Object(out_);
    detail::check(status, {{"id", static_cast<double>(id), 1, 2147483647}, {"opacity", static_cast<double>(opacity), 0, 1}});
    return made;
}

[[nodiscard]] inline Object foreign_object(const Picture &picture, Numbers matrix, bat_id id = 1, const std::string &name = {}, double opacity = 1.0) {
    detail::exactly("matrix", matrix.size(), 6);
    bat_object *out_ = nullptr;
    const bat_status status = bat_object_create_foreign(id, name.c_str(), picture.get(), matrix.data(), opacity, &out_);
    Object made = Object(out_);
    detail::check(status, {{"id", static_cast<double>(id), 1, 2147483647}, {"opacity", static_cast<double>(opacity), 0, 1}});
    return made;
}

[[nodiscard]] inline Object guide_object(int axis, double at, bat_id id = 1) {
    bat_object *out_ = nullptr;
    const bat_status status = bat_object_create_guide(id, axis, at, &out_);
    Object made = Object(out_);
    detail::check(status, {{"id", static_cast<double>(id), 1, 2147483647}, {"axis", static_cast<double>(axis), 0, 1}, {"at", static_cast<double>(at), -1e+75, 1e+75}});
    return made;
}

[[nodiscard]] inline Object plane_object(Numbers origin, Numbers axes, bat_id id = 1, const std::string &name = {}) {
    detail::exactly("origin", origin.size(), 3);
    detail::exactly("axes", axes.size(), 6);
    bat_object *out_ = nullptr;
    const bat_status status = bat_object_create_plane(id, name.c_str(), origin.data(), axes.data(), &out_);
    Object made = Object(out_);
    detail::check(status, {{"id", static_cast<double>(id), 1, 2147483647}});
    return made;
}

[[nodiscard]] inline Object view_object(const bat_viewpoint &view, bat_id id = 1, const std::string &name = {}) {
    bat_object *out_ = nullptr;
    bat_problem problem{};
    const bat_status status = bat_object_create_view(id, name.c_str(), &view, &out_);
    Object made = Object(out_);
    if (status != BAT_OK) detail::check(bat_viewpoint_check(&view, &problem), problem);
    detail::check(status, {{"id", static_cast<double>(id), 1, 2147483647}});
    return made;
}

[[nodiscard]] inline Object surface_object(const Surface &surface, bat_id id = 1, const std::string &name = {}, const bat_style *style = nullptr) {
    bat_object *out_ = nullptr;
    bat_problem problem{};
    const bat_status status = bat_object_create_surface(id, name.c_str(), style, surface.get(), &out_);
    Object made = Object(out_);
    if (status != BAT_OK && style != nullptr) detail::check(bat_style_check(style, &problem), problem);
    detail::check(status, {{"id", static_cast<double>(id), 1, 2147483647}});
    return made;
}

[[nodiscard]] inline Object made_object(const bat_recipe &recipe, const List<Object> &sources, bat_id id = 1, const std::string &name = {}, const bat_style *style = nullptr) {
    bat_object *out_ = nullptr;
    bat_problem problem{};
    const bat_status status = bat_object_create_made(id, name.c_str(), style, &recipe, sources.size(), sources.data(), &out_);
    Object made = Object(out_);
    if (status != BAT_OK && style != nullptr) detail::check(bat_style_check(style, &problem), problem);
    detail::check(status, {{"id", static_cast<double>(id), 1, 2147483647}});
    return made;
}

[[nodiscard]] inline Object mesh_object(const Mesh &mesh, bat_id id = 1, const std::string &name = {}, const bat_style *style = nullptr) {
    bat_object *out_ = nullptr;
    bat_problem problem{};
    const bat_status status = bat_object_create_mesh(id, name.c_str(), style, mesh.get(), &out_);
    Object made = Object(out_);
    if (status != BAT_OK && style != nullptr) detail::check(bat_style_check(style, &problem), problem);
    detail::check(status, {{"id", static_cast<double>(id), 1, 2147483647}});
    return made;
}

[[nodiscard]] inline Object camera_object(const Camera &camera, bat_id id = 1, const std::string &name = {}, const bat_style *style = nullptr, bat_id follows = 0) {
    bat_object *out_ = nullptr;
    bat_problem problem{};
    const bat_status status = bat_object_create_camera(id, name.c_str(), style, camera.get(), follows, &out_);
    Object made = Object(out_);
    if (status != BAT_OK && style != nullptr) detail::check(bat_style_check(style, &problem), problem);
    detail::check(status, {{"id", static_cast<double>(id), 1, 2147483647}, {"follows", static_cast<double>(follows), 0, 2147483647}});
    return made;
}

[[nodiscard]] inline Object skeleton_object(const Motion &motion, bat_id id = 1, const std::string &name = {}, const bat_style *style = nullptr, Numbers place = {}) {
    if (!place.empty()) detail::exactly("place", place.size(), 12);
    bat_object *out_ = nullptr;
    bat_problem problem{};
    const bat_status status = bat_object_create_skeleton(id, name.c_str(), style, motion.get(), place.empty() ? nullptr : place.data(), &out_);
    Object made = Object(out_);
    if (status != BAT_OK && style != nullptr) detail::check(bat_style_check(style, &problem), problem);
    detail::check(status, {{"id", static_cast<double>(id), 1, 2147483647}});
    return made;
}

[[nodiscard]] inline Document document() {
    bat_document *out_ = nullptr;
    const bat_status status = bat_document_create(&out_);
    Document made = Document(out_);
    detail::check(status);
    return made;
}

[[nodiscard]] inline Document read_document(std::string_view text) {
    bat_document *out_ = nullptr;
    bat_problem problem_told{};
    const bat_status status = bat_document_read(text.data(), text.size(), &out_, &problem_told);
    Document made = Document(out_);
    detail::check(status, problem_told);
    return made;
}

[[nodiscard]] inline Curve read_curve(std::string_view text) {
    bat_curve *out_ = nullptr;
    bat_problem problem_told{};
    const bat_status status = bat_curve_read(text.data(), text.size(), &out_, &problem_told);
    Curve made = Curve(out_);
    detail::check(status, problem_told);
    return made;
}

[[nodiscard]] inline Surface read_surface(std::string_view text) {
    bat_surface *out_ = nullptr;
    bat_problem problem_told{};
    const bat_status status = bat_surface_read(text.data(), text.size(), &out_, &problem_told);
    Surface made = Surface(out_);
    detail::check(status, problem_told);
    return made;
}

[[nodiscard]] inline Mesh read_mesh(std::string_view text) {
    bat_polymesh *out_ = nullptr;
    bat_problem problem_told{};
    const bat_status status = bat_polymesh_read(text.data(), text.size(), &out_, &problem_told);
    Mesh made = Mesh(out_);
    detail::check(status, problem_told);
    return made;
}

[[nodiscard]] inline double model_size(const bat_model &model) {
    return bat_model_size(&model);
}

[[nodiscard]] inline detail::Owned<bat_model, bat_model_clear> read_model(std::string_view text) {
    bat_model out_{};
    bat_problem problem_told{};
    const bat_status status = bat_model_read(text.data(), text.size(), &out_, &problem_told);
    detail::check(status, problem_told);
    return detail::Owned<bat_model, bat_model_clear>(out_);
}

[[nodiscard]] inline std::string write_model(const bat_model &model) {
    char *text_ = nullptr;
    size_t size_{};
    const bat_status status = bat_model_write(&model, &text_, &size_);
    std::string made = detail::taken_text(text_, size_);
    detail::check(status);
    return made;
}

[[nodiscard]] inline detail::Owned<bat_model, bat_model_clear> read_obj(std::string_view text) {
    bat_model out_{};
    bat_problem problem_told{};
    const bat_status status = bat_obj_read(text.data(), text.size(), &out_, &problem_told);
    detail::check(status, problem_told);
    return detail::Owned<bat_model, bat_model_clear>(out_);
}

[[nodiscard]] inline std::string write_obj(const bat_model &model) {
    char *text_ = nullptr;
    size_t size_{};
    const bat_status status = bat_obj_write(&model, &text_, &size_);
    std::string made = detail::taken_text(text_, size_);
    detail::check(status);
    return made;
}

[[nodiscard]] inline detail::Owned<bat_model, bat_model_clear> read_iges(std::string_view text) {
    bat_model out_{};
    bat_problem problem_told{};
    const bat_status status = bat_iges_read(text.data(), text.size(), &out_, &problem_told);
    detail::check(status, problem_told);
    return detail::Owned<bat_model, bat_model_clear>(out_);
}

[[nodiscard]] inline std::string write_iges(const bat_model &model) {
    char *bytes_ = nullptr;
    size_t size_{};
    const bat_status status = bat_iges_write(&model, &bytes_, &size_);
    std::string made = detail::taken_text(bytes_, size_);
    detail::check(status);
    return made;
}

[[nodiscard]] inline detail::Owned<bat_model, bat_model_clear> read_step(std::string_view text) {
    bat_model out_{};
    bat_problem problem_told{};
    const bat_status status = bat_step_read(text.data(), text.size(), &out_, &problem_told);
    detail::check(status, problem_told);
    return detail::Owned<bat_model, bat_model_clear>(out_);
}

[[nodiscard]] inline std::string write_step(const bat_model &model) {
    char *bytes_ = nullptr;
    size_t size_{};
    const bat_status status = bat_step_write(&model, &bytes_, &size_);
    std::string made = detail::taken_text(bytes_, size_);
    detail::check(status);
    return made;
}

[[nodiscard]] inline std::string write_stl(const bat_model &model, double tolerance = 0.0) {
    char *bytes_ = nullptr;
    size_t size_{};
    const bat_status status = bat_stl_write(&model, tolerance, &bytes_, &size_);
    std::string made = detail::taken_text(bytes_, size_);
    detail::check(status, {{"tolerance", static_cast<double>(tolerance), 0, 1e+75}});
    return made;
}

[[nodiscard]] inline std::string write_gltf(const bat_model &model, double tolerance = 0.0) {
    char *bytes_ = nullptr;
    size_t size_{};
    const bat_status status = bat_gltf_write(&model, tolerance, &bytes_, &size_);
    std::string made = detail::taken_text(bytes_, size_);
    detail::check(status, {{"tolerance", static_cast<double>(tolerance), 0, 1e+75}});
    return made;
}

[[nodiscard]] inline Take read_bvh(std::string_view text) {
    bat_take *out_ = nullptr;
    bat_problem problem_told{};
    const bat_status status = bat_bvh_read(text.data(), text.size(), &out_, &problem_told);
    Take made = Take(out_);
    detail::check(status, problem_told);
    return made;
}

[[nodiscard]] inline bat_viewpoint read_view(std::string_view text) {
    bat_viewpoint out_{};
    bat_problem problem_told{};
    const bat_status status = bat_viewpoint_read(text.data(), text.size(), &out_, &problem_told);
    detail::check(status, problem_told);
    return out_;
}

[[nodiscard]] inline std::string write_view(const bat_viewpoint &view) {
    char *text_ = nullptr;
    size_t size_{};
    bat_problem problem{};
    const bat_status status = bat_viewpoint_write(&view, &text_, &size_);
    std::string made = detail::taken_text(text_, size_);
    if (status != BAT_OK) detail::check(bat_viewpoint_check(&view, &problem), problem);
    detail::check(status);
    return made;
}

[[nodiscard]] inline detail::Owned<bat_canvas, bat_canvas_clear> read_canvas(std::string_view text) {
    bat_canvas out_{};
    bat_problem problem_told{};
    const bat_status status = bat_canvas_read(text.data(), text.size(), &out_, &problem_told);
    detail::check(status, problem_told);
    return detail::Owned<bat_canvas, bat_canvas_clear>(out_);
}

[[nodiscard]] inline Camera read_camera(std::string_view text) {
    bat_camera *out_ = nullptr;
    bat_problem problem_told{};
    const bat_status status = bat_camera_read(text.data(), text.size(), &out_, &problem_told);
    Camera made = Camera(out_);
    detail::check(status, problem_told);
    return made;
}

[[nodiscard]] inline std::vector<double> read_points(std::string_view text) {
    int dimension_{};
    size_t count_{};
    double *points_ = nullptr;
    bat_problem problem_told{};
    const bat_status status = bat_points_read(text.data(), text.size(), &dimension_, &count_, &points_, &problem_told);
    std::vector<double> made = detail::taken(points_, static_cast<std::size_t>(count_)*static_cast<std::size_t>(dimension_));
    detail::check(status, problem_told);
    return made;
}

[[nodiscard]] inline Shape read_shape(std::string_view text) {
    bat_shape *out_ = nullptr;
    bat_problem problem_told{};
    const bat_status status = bat_shape_read(text.data(), text.size(), &out_, &problem_told);
    Shape made = Shape(out_);
    detail::check(status, problem_told);
    return made;
}

[[nodiscard]] inline Relief read_relief(std::string_view text) {
    bat_relief *out_ = nullptr;
    bat_problem problem_told{};
    const bat_status status = bat_relief_read(text.data(), text.size(), &out_, &problem_told);
    Relief made = Relief(out_);
    detail::check(status, problem_told);
    return made;
}

[[nodiscard]] inline int losses_total(const bat_losses &losses) {
    return bat_losses_total(&losses);
}

[[nodiscard]] inline const char *loss_key(bat_loss kind) {
    return bat_loss_key(kind);
}

[[nodiscard]] inline detail::Owned<bat_sweep_source, bat_sweep_source_clear> read_sweep(std::string_view text) {
    bat_sweep_source out_{};
    bat_problem problem_told{};
    const bat_status status = bat_sweep_read(text.data(), text.size(), &out_, &problem_told);
    detail::check(status, problem_told);
    return detail::Owned<bat_sweep_source, bat_sweep_source_clear>(out_);
}

[[nodiscard]] inline detail::Owned<bat_wires_source, bat_wires_source_clear> read_wires(std::string_view text) {
    bat_wires_source out_{};
    bat_problem problem_told{};
    const bat_status status = bat_wires_read(text.data(), text.size(), &out_, &problem_told);
    detail::check(status, problem_told);
    return detail::Owned<bat_wires_source, bat_wires_source_clear>(out_);
}

inline bool operator==(const Curve &a, const Curve &b) { return a.is_equal(b); }
inline bool operator==(const Surface &a, const Surface &b) { return a.is_equal(b); }
inline bool operator==(const Mesh &a, const Mesh &b) { return a.is_equal(b); }

// What calls of regions take: each of these curves bounds one by itself. It looks at them.
class Regions {
  public:
    explicit Regions(const std::vector<Curve> &of) {
        for (const Curve &one : of) curves_.push_back(one.get());
        for (const bat_curve *&one : curves_) own_.push_back({1, &one, false});
    }
    [[nodiscard]] const bat_region *data() const noexcept { return own_.data(); }
    [[nodiscard]] std::size_t size() const noexcept { return own_.size(); }

  private:
    std::vector<const bat_curve *> curves_;
    std::vector<bat_region> own_;
};

// What calls take that write a model, of one surface or mesh. It looks at it.
class Model {
  public:
    explicit Model(Surface &of) : surface_(of.get()) { own_.surface_count = 1, own_.surfaces = &surface_; }
    explicit Model(Mesh &of) { own_.mesh = of.get(); }
    Model(const Model &) = delete;
    Model &operator=(const Model &) = delete;
    operator const bat_model &() const noexcept { return own_; }

  private:
    bat_surface *surface_ = nullptr;
    bat_model own_{};
};

// The headless editor; its other calls take get().
class Editor : public detail::Handle<bat_editor, bat_editor_free> {
  public:
    Editor() : Handle(make()) {}
    void open(Document drawing, const std::string &name = "") {
        detail::check(bat_editor_open(get(), drawing.release(), name.c_str()));
    }
    void command(const std::string &name) { detail::check(bat_editor_command(get(), name.c_str())); }
    void set(const std::string &property, double value) { detail::check(bat_editor_set(get(), property.c_str(), value)); }
    void pointer(Span<const bat_pointer> events) { bat_editor_pointer(get(), events.size(), events.data()); }
    [[nodiscard]] const bat_frame *frame() { return bat_editor_frame(get()); }

  private:
    static bat_editor *make() {
        bat_editor *out = nullptr;
        detail::check(bat_editor_create(&out));
        return out;
    }
};

} // namespace bat

#endif
