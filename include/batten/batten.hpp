// Batten in C++20: objects that free themselves, std::span in and out, exceptions for errors. Header only, over the C
// interface, whose headers say what each call does, costs and refuses; get() gives the C object for everything else.
//
// Curves and documents are moved, not copied, unless copy() is asked for. Points are rows of doubles, x y [z] each. A
// status other than BAT_OK throws bat::error; where the best result is handed over with BAT_TOLERANCE, the result is
// returned and says so (within).
#ifndef BATTEN_BATTEN_HPP
#define BATTEN_BATTEN_HPP

#include <batten/batten.h>

#include <array>
#include <cstddef>
#include <memory>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bat {

// What a call refused, with the status it gave.
class error : public std::runtime_error {
  public:
    explicit error(bat_status status) : std::runtime_error(bat_status_message(status)), status_(status) {}
    error(bat_status status, const bat_problem &problem)
        : std::runtime_error(std::string(problem.place) + ": " + problem.message), status_(status) {}
    [[nodiscard]] bat_status status() const noexcept { return status_; }

  private:
    bat_status status_;
};

inline void check(bat_status status) {
    if (status != BAT_OK) throw error(status);
}

// True: the tolerance was met; false: what was handed over is the best that was found.
inline bool check_within(bat_status status) {
    if (status != BAT_OK && status != BAT_TOLERANCE) throw error(status);
    return status == BAT_OK;
}

using points = std::span<const double>;

namespace detail {
template <auto Free> struct deleter {
    template <class T> void operator()(T *object) const noexcept { Free(object); }
};
template <class T, auto Free> using handle = std::unique_ptr<T, deleter<Free>>;

inline std::size_t rows(points values, int dimension) {
    if (dimension < 2 || dimension > BAT_DIMENSION_MAX ||
        values.size() % static_cast<std::size_t>(dimension) != 0)
        throw error(BAT_DIMENSION);
    return values.size() / static_cast<std::size_t>(dimension);
}

template <class T, class Call> T *make(Call call) {
    T *out = nullptr;
    check(call(&out));
    return out;
}

template <class T, class Read> T *read(Read call, std::string_view text) {
    T *out = nullptr;
    bat_problem problem{};
    if (const bat_status status = call(text.data(), text.size(), &out, &problem); status != BAT_OK)
        throw error(status, problem);
    return out;
}

inline std::string text_of(char *text, std::size_t size) {
    const handle<char, bat_free> owner(text);
    return {text, size};
}
} // namespace detail

// A stroke of the pen: its points, and pressure and time where they are known (empty: not).
struct stroke {
    points at;
    int dimension = 2;
    std::span<const double> pressure{}, time{};

    [[nodiscard]] bat_stroke c() const {
        const std::size_t count = detail::rows(at, dimension);
        if ((!pressure.empty() && pressure.size() != count) || (!time.empty() && time.size() != count))
            throw error(BAT_COUNT);
        return {dimension, count, at.data(), pressure.empty() ? nullptr : pressure.data(),
                time.empty() ? nullptr : time.data()};
    }
};

// A B-spline curve: a value that never changes.
class curve {
  public:
    explicit curve(bat_curve *taken) noexcept : own_(taken) {} // takes the C object over
    curve(int dimension, int degree, bool closed, points control, std::span<const double> knots)
        : own_(detail::make<bat_curve>([&](bat_curve **out) {
              return bat_curve_create(dimension, degree, closed, detail::rows(control, dimension),
                                      control.data(), static_cast<int>(knots.size()), knots.data(), out);
          })) {}
    static curve clamped(int dimension, int degree, points control) {
        return curve(detail::make<bat_curve>([&](bat_curve **out) {
            return bat_curve_create_clamped(dimension, degree, detail::rows(control, dimension),
                                            control.data(), out);
        }));
    }
    // The C2 cubic through points.
    static curve through(points at, int dimension = 2, bool closed = false) {
        return curve(detail::make<bat_curve>([&](bat_curve **out) {
            return bat_interpolate(dimension, closed, detail::rows(at, dimension), at.data(), nullptr, out);
        }));
    }
    static curve read(std::string_view json) { return curve(detail::read<bat_curve>(bat_curve_read, json)); }

    [[nodiscard]] const bat_curve *get() const noexcept { return own_.get(); }
    [[nodiscard]] bat_curve *release() noexcept { return own_.release(); }
    [[nodiscard]] curve copy() const { return map(bat_curve_copy); }

    [[nodiscard]] int degree() const { return bat_curve_degree(get()); }
    [[nodiscard]] int dimension() const { return bat_curve_dimension(get()); }
    [[nodiscard]] bool closed() const { return bat_curve_is_closed(get()); }
    [[nodiscard]] std::size_t count() const { return bat_curve_count(get()); }
    [[nodiscard]] points control() const {
        return {bat_curve_points(get()), count() * width()};
    } // the curve's own
    [[nodiscard]] points knots() const {
        return {bat_curve_knots(get()), static_cast<std::size_t>(bat_curve_knot_count(get()))};
    }
    [[nodiscard]] std::array<double, 2> domain() const {
        std::array<double, 2> out{};
        bat_curve_domain(get(), out.data());
        return out;
    }
    friend bool operator==(const curve &a, const curve &b) { return bat_curve_is_equal(a.get(), b.get()); }

    // Position at u, and derivatives up to `order` after it.
    [[nodiscard]] std::vector<double> at(double u, int order = 0) const {
        if (order < 0) throw error(BAT_ARGUMENT);
        std::vector<double> out((static_cast<std::size_t>(order) + 1) * width());
        bat_curve_eval(get(), u, order, out.data());
        return out;
    }
    // At many parameters, ascending, into an array of the caller's: (order + 1) * dimension numbers for each.
    void at(std::span<const double> u, std::span<double> out, int order = 0) const {
        if (order < 0 || out.size() != u.size() * (static_cast<std::size_t>(order) + 1) * width())
            throw error(BAT_COUNT);
        check(bat_curve_eval_many(get(), u.size(), u.data(), order, out.data()));
    }
    // Points at `many` parameters that are spread evenly.
    [[nodiscard]] std::vector<double> sample(std::size_t many) const {
        std::vector<double> u(many), out(many * width());
        bat_curve_spread(get(), many, u.data());
        at(u, out);
        return out;
    }
    [[nodiscard]] double length(double relative = 1e-9) const {
        const auto ends = domain();
        return bat_curve_length(get(), ends[0], ends[1], relative);
    }
    [[nodiscard]] double curvature(double u) const { return bat_curve_curvature(get(), u); }
    [[nodiscard]] bat_near nearest(points to) const {
        if (to.size() != width()) throw error(BAT_DIMENSION);
        bat_near out{};
        check(bat_curve_nearest(get(), to.data(), &out));
        return out;
    }
    [[nodiscard]] std::vector<bat_frame3> frames(std::size_t many,
                                                 const bat_frame_options *options = nullptr) const {
        std::vector<double> u(many);
        std::vector<bat_frame3> out(many);
        bat_curve_spread(get(), many, u.data());
        check(bat_frames(get(), many, u.data(), options, out.data(), nullptr));
        return out;
    }
    // Cubic Béziers for drawing, 4 points each.
    [[nodiscard]] std::vector<double> cubics(double tolerance = 0.01) const {
        int segments = 0;
        double *taken = nullptr;
        check_within(bat_curve_to_cubics(get(), tolerance, &segments, &taken));
        const detail::handle<double, bat_free> owner(taken);
        return {taken, taken + static_cast<std::size_t>(segments) * 4 * width()};
    }

    [[nodiscard]] curve insert(double u, int times = 1) const { return map(bat_curve_insert_knot, u, times); }
    [[nodiscard]] curve elevate(int degree) const { return map(bat_curve_elevate, degree); }
    [[nodiscard]] curve reverse() const { return map(bat_curve_reverse); }
    [[nodiscard]] curve piece(double from, double to) const { return map(bat_curve_piece, from, to); }
    [[nodiscard]] curve close(double tolerance) const { return map(bat_curve_close, tolerance); }
    // dimension rows of dimension + 1 numbers, translation last.
    [[nodiscard]] curve transform(std::span<const double> matrix) const {
        if (matrix.size() != width() * (width() + 1)) throw error(BAT_COUNT);
        return map(bat_curve_transform, matrix.data());
    }
    // As few knots as keep it within the tolerance; corners, in radians, stay.
    [[nodiscard]] curve simplify(double tolerance, double corner = std::numbers::pi / 12) const {
        return curve(detail::make<bat_curve>(
            [&](bat_curve **out) { return bat_curve_simplify(get(), tolerance, corner, out, nullptr); }));
    }
    [[nodiscard]] std::pair<curve, curve> split(double u) const {
        bat_curve *left = nullptr, *right = nullptr;
        check(bat_curve_split(get(), u, &left, &right));
        return {curve(left), curve(right)};
    }
    [[nodiscard]] std::string write() const {
        char *text = nullptr;
        std::size_t size = 0;
        check(bat_curve_write(get(), &text, &size));
        return detail::text_of(text, size);
    }

  private:
    template <class Call, class... Args> [[nodiscard]] curve map(Call call, Args... args) const {
        return curve(detail::make<bat_curve>([&](bat_curve **out) { return call(get(), args..., out); }));
    }
    [[nodiscard]] std::size_t width() const { return static_cast<std::size_t>(dimension()); }

    detail::handle<bat_curve, bat_curve_free> own_;
};

// A curve that was found within a tolerance, or is the best that was found.
template <class Report> struct found {
    bat::curve curve;
    Report report;
    bool within;

    template <class Call> static found from(Call call) {
        bat_curve *out = nullptr;
        Report made{};
        const bool met = check_within(call(&out, &made));
        return {bat::curve(out), made, met};
    }
};

inline found<bat_fit_report> fit(points at, const bat_fit_options &options, int dimension = 2) {
    return found<bat_fit_report>::from([&](bat_curve **out, bat_fit_report *report) {
        return bat_fit(dimension, detail::rows(at, dimension), at.data(), &options, out, report);
    });
}

inline found<bat_fit_report> fit(points at, double tolerance = 1, int dimension = 2) {
    bat_fit_options options = bat_fit_defaults();
    options.tolerance = tolerance;
    return fit(at, options, dimension);
}

// Draw over a curve: it follows the stroke there.
inline found<bat_sketch_report> sketch(const curve &under, const stroke &over,
                                       const bat_sketch_options *options = nullptr) {
    const bat_stroke pen = over.c();
    return found<bat_sketch_report>::from([&](bat_curve **out, bat_sketch_report *report) {
        return bat_sketch(under.get(), &pen, options, out, report);
    });
}

// A new curve from a stroke.
inline found<bat_sketch_report> sketch(const stroke &drawn, const bat_sketch_options *options = nullptr) {
    const bat_stroke pen = drawn.c();
    return found<bat_sketch_report>::from([&](bat_curve **out, bat_sketch_report *report) {
        return bat_sketch_new(&pen, false, options, out, report);
    });
}

// The same while the pen is down: add what it has drawn, show the preview, commit when it is lifted.
class live {
  public:
    explicit live(int dimension = 2, const bat_sketch_options *options = nullptr)
        : live(nullptr, dimension, BAT_SKETCH_NEW, options) {}
    explicit live(const curve &under, const bat_sketch_options *options = nullptr)
        : live(under.get(), under.dimension(), BAT_SKETCH_REDRAW, options) {}

    void add(const stroke &samples) {
        const bat_stroke pen = samples.c();
        check(bat_sketch_live_add(own_.get(), &pen));
    }
    void add(double x, double y) {
        const std::array<double, 2> at{x, y};
        add(stroke{at});
    }
    [[nodiscard]] curve preview() {
        bat_curve *out = nullptr;
        check_within(bat_sketch_live_preview(own_.get(), &out, nullptr));
        return curve(out);
    }
    // Ends the session, whatever comes of it.
    [[nodiscard]] found<bat_sketch_report> commit() {
        return found<bat_sketch_report>::from([&](bat_curve **out, bat_sketch_report *report) {
            return bat_sketch_live_commit(own_.release(), out, report);
        });
    }

  private:
    live(const bat_curve *under, int dimension, bat_sketch_kind kind, const bat_sketch_options *options) {
        own_.reset(detail::make<bat_sketch_live>([&](bat_sketch_live **out) {
            return bat_sketch_live_begin(under, dimension, kind, options, out);
        }));
    }
    detail::handle<bat_sketch_live, bat_sketch_live_cancel> own_;
};

// The G1 spline through points with a direction at each (zero: none given).
inline curve spline(points at, points tangents = {}, int dimension = 2, bool closed = false) {
    const std::size_t count = detail::rows(at, dimension);
    if (!tangents.empty() && tangents.size() != at.size()) throw error(BAT_COUNT);
    const bat_spline given{dimension, closed, count, at.data(), tangents.empty() ? nullptr : tangents.data(),
                           nullptr};
    return curve(detail::make<bat_curve>(
        [&](bat_curve **out) { return bat_tangents(&given, nullptr, nullptr, nullptr, nullptr, out); }));
}

// A curve with levels of detail: level 0 is the base, the last one what is seen.
class shape {
  public:
    explicit shape(const curve &base, const bat_shape_options *options = nullptr)
        : shape(detail::make<bat_shape>(
              [&](bat_shape **out) { return bat_shape_create(base.get(), options, out); })) {}
    static shape decompose(const curve &of, int levels, const bat_shape_options *options = nullptr) {
        return shape(detail::make<bat_shape>(
            [&](bat_shape **out) { return bat_shape_decompose(of.get(), levels, options, out); }));
    }
    [[nodiscard]] const bat_shape *get() const noexcept { return own_.get(); }
    [[nodiscard]] bat_shape *get() noexcept { return own_.get(); }
    [[nodiscard]] int levels() const { return bat_shape_levels(get()); }
    void add_level() { check(bat_shape_add_level(get(), 0, nullptr, nullptr, nullptr)); }
    // Moves the point of that level at u by exactly delta.
    void drag(int level, double u, points delta) {
        const bat_curve *of = bat_shape_curve(get(), level);
        if (of == nullptr) throw error(BAT_ARGUMENT);
        if (delta.size() != static_cast<std::size_t>(bat_curve_dimension(of))) throw error(BAT_DIMENSION);
        check(bat_shape_drag(get(), level, u, delta.data()));
    }
    [[nodiscard]] curve flatten() const {
        return curve(detail::make<bat_curve>([&](bat_curve **out) { return bat_shape_flatten(get(), out); }));
    }

  private:
    explicit shape(bat_shape *taken) noexcept : own_(taken) {}
    detail::handle<bat_shape, bat_shape_free> own_;
};

// A drawing: read, written, handed to the C interface.
class document {
  public:
    document() : own_(detail::make<bat_document>(bat_document_create)) {}
    explicit document(bat_document *taken) noexcept : own_(taken) {}
    static document read(std::string_view json) {
        return document(detail::read<bat_document>(bat_document_read, json));
    }
    [[nodiscard]] const bat_document *get() const noexcept { return own_.get(); }
    [[nodiscard]] bat_document *get() noexcept { return own_.get(); }
    [[nodiscard]] bat_document *release() noexcept { return own_.release(); }
    [[nodiscard]] int count() const { return bat_document_count(get()); }
    [[nodiscard]] std::string write() const { return written(bat_document_write); }
    [[nodiscard]] std::string svg(bool with_native = true) const {
        return written(bat_svg_write, with_native);
    }

  private:
    template <class Call, class... Args> [[nodiscard]] std::string written(Call call, Args... args) const {
        char *text = nullptr;
        std::size_t size = 0;
        check(call(get(), args..., &text, &size));
        return detail::text_of(text, size);
    }
    detail::handle<bat_document, bat_document_free> own_;
};

// The headless editor; its other calls take get().
class editor {
  public:
    editor() : own_(detail::make<bat_editor>(bat_editor_create)) {}
    void open(document drawing, const std::string &name = "") {
        check(bat_editor_open(get(), drawing.release(), name.c_str()));
    }
    void command(const std::string &name) { check(bat_editor_command(get(), name.c_str())); }
    void set(const std::string &property, double value) {
        check(bat_editor_set(get(), property.c_str(), value));
    }
    void pointer(std::span<const bat_pointer> events) {
        bat_editor_pointer(get(), events.size(), events.data());
    }
    [[nodiscard]] const bat_frame *frame() { return bat_editor_frame(get()); }
    [[nodiscard]] bat_editor *get() noexcept { return own_.get(); }

  private:
    detail::handle<bat_editor, bat_editor_free> own_;
};

} // namespace bat

#endif
