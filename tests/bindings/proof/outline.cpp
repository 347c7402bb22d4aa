// Reads the curves of an SVG file, simplifies them, moves their outlines apart, unites what overlaps, and writes an SVG file.
// Usage: outline drawing.svg outline.svg
#include <batten/batten.hpp>
#include <batten/svg_read.h>

#include <cstdio>
#include <fstream>

int main(int, char **argv) try {
    std::ifstream file(argv[1]);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    bat_document *read = nullptr;
    bat_problem problem{};
    bat::detail::check(bat_svg_read(text.data(), text.size(), nullptr, &read, nullptr, &problem), problem);
    const bat::Document drawing(read);

    std::vector<bat::Curve> apart;
    for (int i = 0; i < drawing.count(); i++) {
        const bat::Object object = *drawing.at(i);
        for (int k = 0; k < object.curve_count(); k++) {
            const bat::Curve simple = object.curve(k)->simplify(0.05).out;
            for (bat::Curve &one : simple.offset(simple.area() > 0 ? -3 : 3, 0.01).curves)
                apart.push_back(std::move(one));
        }
    }
    const std::vector<bat::Curve> united = bat::combine(BAT_REGION_UNION, bat::Regions(apart), 0.01);

    bat::Document out = bat::document();
    out.set_page({0, 0, 120, 80});
    bat_style style = bat_style_defaults();
    style.filled = true, style.stroked = false;
    out.insert(0, bat::path_object(united, out.new_id(), "outline", &style));
    std::ofstream(argv[2]) << out.to_svg(false);
    std::printf("%d objects, %zu outlines, %zu united\n", drawing.count(), apart.size(), united.size());
} catch (const bat::Error &error) {
    std::fprintf(stderr, "%s: %s\n", argv[1], error.what());
    return 1;
}
