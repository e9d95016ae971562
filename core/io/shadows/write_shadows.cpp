#include "core/io/shadows/write_shadows.h"

#include <fmt/format.h>
#include <algorithm>
#include <iterator>

#include "core/base/safe_text.h"
#include "core/io/shadows/shadow_drawing.h"

namespace noonmark {

namespace {

constexpr std::size_t maxLetters = 200;

bool isPlain(char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
           (letter >= '0' && letter <= '9') || letter == '-' || letter == '_' || letter == '.';
}

// The first byte of a letter in UTF-8 stands for the letter.
std::string plainName(std::string_view wanted) {
    std::string name;
    for (const char letter : wanted)
        if ((static_cast<unsigned char>(letter) & 0xC0U) != 0x80U) name += isPlain(letter) ? letter : '_';
    name.resize(std::min(name.size(), maxLetters));
    return name.empty() ? "layer" : name;
}

std::string lowerCase(std::string name) {
    std::ranges::transform(name, name.begin(), [](char letter) {
        return letter >= 'A' && letter <= 'Z' ? char(letter - 'A' + 'a') : letter;
    });
    return name;
}

}  // namespace

std::string LayerNames::add(std::string_view wanted) {
    const std::string plain = plainName(wanted);
    std::string name = plain;
    for (int copy = 2; !taken_.insert(lowerCase(name)).second; ++copy)
        name = plain + "_" + std::to_string(copy);
    return name;
}

namespace {

constexpr double footMm = 8;  // below the picture: a line of text

/// Writes shapes in millimetres on paper, north up.
class SvgWriter {
public:
    SvgWriter(const Box2& area, double scale) : area_(area), mmPerM_(1000 / scale) {
        const glm::dvec2 size = glm::dvec2(area.high) - glm::dvec2(area.low);
        size_ = size * mmPerM_;
        print(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.3f}mm\" height=\"{1:.3f}mm\" "
            "viewBox=\"0 0 {0:.3f} {1:.3f}\">\n",
            size_.x, size_.y + footMm);
    }

    void begin(std::string_view id, const char* style) { print("<g id=\"{}\" {}>\n", escapeXml(id), style); }
    void end() { text_ += "</g>\n"; }

    void addPolygons(const std::vector<Footprint>& polygons, std::string_view title) {
        text_ += "<path d=\"";
        for (const Footprint& polygon : polygons) {
            addRing(polygon.outer);
            for (const Ring& hole : polygon.holes) addRing(hole);
        }
        print("\"><title>{}</title></path>\n", escapeXml(title));
    }

    // Buildings reach beyond the map: the foot covers them. A clip path would be simpler, but some programs
    // draw its outside.
    std::string finish(std::string_view foot) {
        print("<rect y=\"{:.3f}\" width=\"{:.3f}\" height=\"{:.3f}\" fill=\"#ffffff\"/>\n", size_.y, size_.x,
              footMm);
        print(
            "<rect width=\"{:.3f}\" height=\"{:.3f}\" fill=\"none\" stroke=\"#808080\" "
            "stroke-width=\"0.1\"/>\n",
            size_.x, size_.y);
        print("<text x=\"0\" y=\"{:.3f}\" font-family=\"sans-serif\" font-size=\"3\">{}</text>\n</svg>\n",
              size_.y + footMm - 3, escapeXml(foot));
        return std::move(text_);
    }

private:
    void addRing(const Ring& ring) {
        char command = 'M';
        for (const glm::vec2 point : ring) {
            const glm::dvec2 at((double(point.x) - double(area_.low.x)) * mmPerM_,
                                (double(area_.high.y) - double(point.y)) * mmPerM_);
            print("{}{:.4f} {:.4f}", command, at.x, at.y);
            command = 'L';
        }
        text_ += 'Z';
    }

    template <class... Args>
    void print(fmt::format_string<Args...> pattern, Args&&... args) {
        fmt::format_to(std::back_inserter(text_), pattern, std::forward<Args>(args)...);
    }

    const Box2& area_;
    double mmPerM_;
    glm::dvec2 size_{};
    std::string text_;
};

const char* styleOfKind(std::string_view kind) {
    if (kind == "incremental")
        return "fill=\"#ef9a9a\" fill-rule=\"evenodd\" stroke=\"#c62828\" stroke-width=\"0.15\"";
    if (kind == "gained")
        return "fill=\"#fff59d\" fill-rule=\"evenodd\" stroke=\"#f9a825\" stroke-width=\"0.15\"";
    return "fill=\"#cfcfcf\" fill-rule=\"evenodd\" stroke=\"none\"";
}

const char* styleOfBuildings(BuildingState state) {
    if (state == BuildingState::proposed)
        return "fill=\"#c62828\" fill-opacity=\"0.4\" stroke=\"#c00000\" stroke-width=\"0.25\"";
    if (state == BuildingState::removed)
        return "fill=\"none\" stroke=\"#a0a0a0\" stroke-width=\"0.15\" stroke-dasharray=\"1 0.6\"";
    return "fill=\"#ffffff\" stroke=\"#505050\" stroke-width=\"0.1\"";
}

void drawBuildings(const ShadowDrawing& drawing, SvgWriter& svg) {
    for (const BuildingState state :
         {BuildingState::unchanged, BuildingState::removed, BuildingState::proposed}) {
        svg.begin(fmt::format("buildings {}", nameOf(state)), styleOfBuildings(state));
        for (const DrawnPart& part : drawing.buildings)
            if (part.state == state)
                svg.addPolygons(
                    {part.outline},
                    fmt::format("{} {:.1f} m", part.name.empty() ? part.id : part.name, part.topM));
        svg.end();
    }
}

}  // namespace

std::string drawShadowsSvg(const ShadowDrawing& drawing, const DrawnMoment& moment, double scale) {
    SvgWriter svg(drawing.area, scale);
    for (const auto& [kind, polygons] : listShadows(moment.outlines)) {
        svg.begin(kind, styleOfKind(kind));
        if (!polygons->empty())
            svg.addPolygons(*polygons, fmt::format("{}, {:.1f} m2", kind, area(*polygons)));
        svg.end();
    }
    drawBuildings(drawing, svg);
    svg.begin("places", "fill=\"none\" stroke=\"#2e7d32\" stroke-width=\"0.3\"");
    for (const Place& place : drawing.places) svg.addPolygons(place.polygons, place.name);
    svg.end();
    return svg.finish(fmt::format("{}. Sun: azimuth {:.1f}, altitude {:.1f} deg. 1:{:g}, north is up",
                                  moment.time.clock, moment.time.sun.azimuthDeg, moment.time.sun.altitudeDeg,
                                  scale));
}

}  // namespace noonmark
