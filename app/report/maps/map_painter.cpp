#include "app/report/maps/map_painter.h"

#include <QFontMetricsF>
#include <QPaintEngine>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <set>
#include <string_view>

#include "app/report/maps/city_painter.h"
#include "app/report/maps/sheet_text.h"
#include "core/base/units.h"
#include "core/city/building_heights.h"
#include "core/engines/shade_trees.h"

namespace noonmark {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

class Picture {
public:
    Picture(const ShadowField& field, const Receivers& receivers, ShadowMeasure measure,
            const ColourScale& scale)
        : grid_(field.grid), receivers_(receivers), values_(getValues(field, measure)), scale_(scale) {}

    [[nodiscard]] QImage reduced(int factor) const {
        const auto pixels = [factor](int cells) { return (cells + factor - 1) / factor; };
        QImage image(pixels(grid_.columns), pixels(grid_.rows), QImage::Format_RGB32);
        if (image.isNull()) return image;
        for (int y = 0; y < image.height(); ++y) paintLine(image, y, factor);
        return image;
    }

private:
    void paintLine(QImage& image, int y, int factor) const {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        const int row = grid_.rows - (y + 1) * factor;  // may be negative where the last block is cut
        for (int x = 0; x < image.width(); ++x) line[x] = colourOf(valueAt(x, row, factor));
    }

    [[nodiscard]] double valueAt(int x, int row, int factor) const {
        if (factor > 1) return meanOf(x * factor, row, factor);
        const float value = values_[grid_.index(x, row)];
        return std::isnan(value) && isBuilding(x, row) ? meanOf(x - 1, row - 1, 3) : double(value);
    }

    [[nodiscard]] QRgb colourOf(double value) const {
        const auto colour = scale_.pick(value);
        return colour ? qRgb(colour->red, colour->green, colour->blue) : qRgb(255, 255, 255);
    }

    /// Mean over the receivers in the square of `side` cells with this south-western cell.
    [[nodiscard]] double meanOf(int column, int row, int side) const {
        double sum = 0;
        int count = 0;
        for (int r = std::max(row, 0); r < std::min(row + side, grid_.rows); ++r)
            for (int c = std::max(column, 0); c < std::min(column + side, grid_.columns); ++c) {
                const float value = values_[grid_.index(c, r)];
                if (std::isnan(value)) continue;
                sum += double(value);
                ++count;
            }
        return count > 0 ? sum / count : nothing;
    }

    [[nodiscard]] bool isBuilding(int column, int row) const {
        const std::size_t cell = grid_.index(column, row);
        return cell < receivers_.kind.size() && receivers_.kind[cell] == CellKind::building;
    }

    const Grid& grid_;
    const Receivers& receivers_;
    const std::vector<float>& values_;
    const ColourScale& scale_;
};

int factorFor(const Grid& grid, int wantedPixels) {
    return std::max(1, std::max(grid.columns, grid.rows) / std::max(1, wantedPixels));
}

int pixelsOf(int cells, int factor) { return (cells + factor - 1) / factor; }

QRgb meanColour(const Grid& grid, const CellColour& colour, int column, int row, int side) {
    int red = 0, green = 0, blue = 0, count = 0;
    for (int r = std::max(row, 0); r < row + side; ++r)
        for (int c = column; c < std::min(column + side, grid.columns); ++c, ++count) {
            const QColor one = colour(grid.index(c, r)).value_or(Qt::white);
            red += one.red();
            green += one.green();
            blue += one.blue();
        }
    return count > 0 ? qRgb(red / count, green / count, blue / count) : qRgb(255, 255, 255);
}

}  // namespace

FieldImage makeColourImage(const Grid& grid, const CellColour& colour, int wantedPixels) {
    const int factor = factorFor(grid, wantedPixels);
    QImage image(pixelsOf(grid.columns, factor), pixelsOf(grid.rows, factor), QImage::Format_RGB32);
    for (int y = 0; y < image.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        const int row = grid.rows - (y + 1) * factor;  // may be negative where the last block is cut
        for (int x = 0; x < image.width(); ++x) line[x] = meanColour(grid, colour, x * factor, row, factor);
    }
    return {image, factor};
}

FieldImage makeFieldImage(const ShadowField& field, const Receivers& receivers, ShadowMeasure measure,
                          const ColourScale& scale, int wantedPixels) {
    const int factor = factorFor(field.grid, wantedPixels);
    return {Picture(field, receivers, measure, scale).reduced(factor), factor};
}

namespace {

Box2 worldOf(const Region& region, const Grid& grid) {
    Box2 world = bounds(region);
    world.add(glm::vec2(grid.westM, grid.southM));
    world.add(glm::vec2(grid.eastM(), grid.northM()));
    return world;
}

QPainterPath pathOf(const Region& region, const MapView& view) {
    QPainterPath path;
    path.setFillRule(Qt::WindingFill);
    for (const Footprint& polygon : region.polygons) view.addTo(path, polygon);
    return path;
}

/// Screen pixels, or four per point in print: 288 dpi.
int wantedPixels(const Canvas& canvas, const QRectF& field) {
    const double longer = std::max(field.width(), field.height());
    const double perUnit = std::min(1.0, 4 / canvas.point);
    return int(std::ceil(longer * perUnit));
}

/// The rectangle of the picture; its last pixels may extend beyond the grid.
QRectF placeOf(const FieldImage& field, const QRectF& grid, double unitsPerCell) {
    const double pixel = unitsPerCell * field.cellsPerPixel;
    return {grid.topLeft(), QSizeF(field.image.width() * pixel, field.image.height() * pixel)};
}

/// PDF viewers blur coarse pictures, those of less than 144 dpi. Scaling by whole pixels per cell keeps edges
/// sharp.
QImage crisp(const QImage& image, const QPainter& painter, int wanted) {
    const int longer = std::max(image.width(), image.height());
    if (painter.paintEngine()->type() != QPaintEngine::Pdf || longer == 0 || 2 * longer >= wanted)
        return image;
    const int times = (wanted + longer - 1) / longer;
    return image.scaled(image.width() * times, image.height() * times);
}

/// The pixels of a picture at `place` that lie in `shown`, in whole pixels.
QRect pixelsIn(const QRectF& shown, const QRectF& place, const QSize& picture) {
    const double width = place.width() / picture.width(), height = place.height() / picture.height();
    const QRectF part = shown.translated(-place.topLeft());
    return QRectF(part.left() / width, part.top() / height, part.width() / width, part.height() / height)
        .toAlignedRect()
        .intersected(QRect(QPoint(0, 0), picture));
}

/// The part of the field that a map shows: the whole one may be larger than any picture, scaled to its
/// pixels.
void cutTo(const QRectF& shown, QImage& picture, QRectF& place) {
    const QRect pixels = pixelsIn(shown, place, picture.size());
    if (pixels.size() == picture.size()) return;
    const double width = place.width() / picture.width(), height = place.height() / picture.height();
    place = {place.left() + pixels.left() * width, place.top() + pixels.top() * height,
             pixels.width() * width, pixels.height() * height};
    picture = picture.copy(pixels);
}

void paintField(const Canvas& canvas, const MapView& view, const MapScene& scene) {
    if (!scene.image) return;
    const QRectF grid = view.rectOf(scene.grid);
    FieldImage field = scene.image(wantedPixels(canvas, grid));
    QRectF place = placeOf(field, grid, scene.grid.cellM * view.unitsPerM());
    if (field.image.isNull() || !place.intersects(view.target())) return;
    cutTo(view.target(), field.image, place);
    canvas.painter.save();
    canvas.painter.setClipRect(grid.intersected(view.target()), Qt::IntersectClip);
    canvas.painter.setRenderHint(QPainter::LosslessImageRendering);
    canvas.painter.setRenderHint(QPainter::SmoothPixmapTransform, field.image.width() > place.width());
    canvas.painter.drawImage(place, crisp(field.image, canvas.painter, wantedPixels(canvas, place)));
    canvas.painter.restore();
}

void paintCity(const Canvas& canvas, const MapView& view, const MapScene& scene, const QPainterPath& region) {
    const City& city = scene.city;
    if (scene.fillOf) return paintBuildings(canvas, view, city, {{}, ink::quiet, 0.25, scene.fillOf});
    paintBuildings(canvas, view, city, withProposals({ink::context, ink::contextLine}));
    canvas.painter.save();
    canvas.painter.setClipPath(region, Qt::IntersectClip);
    paintBuildings(canvas, view, city, withProposals({ink::building, ink::buildingLine}));
    canvas.painter.restore();
}

void paintOutline(const Canvas& canvas, const QPainterPath& region) {
    canvas.painter.setBrush(Qt::NoBrush);
    canvas.painter.setPen(linePen(canvas, ink::paper, 2.4));
    canvas.painter.drawPath(region);
    canvas.painter.setPen(linePen(canvas, ink::text, 0.9));
    canvas.painter.drawPath(region);
}

constexpr double markRadiusPt = 5;

void paintMark(const Canvas& canvas, const QPointF& centre, const QString& text) {
    const double radius = markRadiusPt * canvas.point;
    const QRectF disc(centre - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius));
    canvas.painter.setBrush(ink::paper);
    canvas.painter.setPen(linePen(canvas, ink::text, 0.6));
    canvas.painter.drawEllipse(disc);
    canvas.painter.setFont(textFont(canvas, 5.6, QFont::Bold));
    canvas.painter.drawText(disc, Qt::AlignCenter, text);
}

void paintMarks(const Canvas& canvas, const MapView& view, const std::vector<MapMark>& marks) {
    const double apart = 2 * markRadiusPt * canvas.point;
    const QRectF room = view.target().adjusted(apart / 2, apart / 2, -apart / 2, -apart / 2);
    std::vector<QPointF> painted;
    for (const MapMark& mark : marks) {
        const QPointF at = view.at(mark.at);
        const auto covers = [&](const QPointF& other) {
            return std::hypot(at.x() - other.x(), at.y() - other.y()) < apart;
        };
        if (!room.contains(at) || std::ranges::any_of(painted, covers)) continue;
        paintMark(canvas, at, mark.text);
        painted.push_back(at);
    }
}

/// Above the building; "120 m". Buildings whose label would cover another one's have none.
void paintProposal(const Canvas& canvas, const MapView& view, const City& proposal, UnitSystem units) {
    paintBuildings(canvas, view, proposal, {shade::proposal, ink::text, 0.9});
    const QFont font = textFont(canvas, 6.6, QFont::Bold);
    const QFontMetricsF metrics(font, canvas.painter.device());
    canvas.painter.setFont(font);
    std::vector<QRectF> labels;
    for (const auto& building : proposal.buildings) {
        const Box2 box = bounds(*building);
        const glm::dvec2 middle = glm::dvec2(box.low + box.high) / 2.0;
        const QString text = QString::fromStdString(
            formatLength(double(topM(*building)) - double(groundAt(proposal, middle)), units, 0));
        QRectF label(0, 0, metrics.horizontalAdvance(text) + 3 * canvas.point, 9 * canvas.point);
        label.moveCenter(view.at(middle));
        label.moveBottom(view.at({middle.x, double(box.high.y)}).y() - 2 * canvas.point);
        const bool isFree =
            std::ranges::none_of(labels, [&](const QRectF& other) { return other.intersects(label); });
        if (!isFree || !view.target().contains(label)) continue;
        canvas.painter.fillRect(label, QColor(255, 255, 255, 225));
        canvas.painter.setPen(shade::proposal);
        canvas.painter.drawText(label, Qt::AlignCenter, text);
        labels.push_back(label);
    }
}

}  // namespace

Box2 shownGround(const MapScene& scene) {
    return scene.shown ? *scene.shown : worldOf(scene.region, scene.grid);
}

std::optional<Box2> zoomOn(const Box2& changed, const MapScene& scene) {
    constexpr float minM = 60, aroundM = 15;
    constexpr double mostOfMap = 0.6;  // a larger change needs no closer view
    if (changed.empty()) return std::nullopt;
    const Box2 all = shownGround(scene);
    const glm::vec2 middle = (changed.low + changed.high) / 2.0F;
    const glm::vec2 half = glm::max((changed.high - changed.low) / 2.0F + aroundM, glm::vec2(minM / 2));
    const Box2 zoom{glm::max(middle - half, all.low), glm::min(middle + half, all.high)};
    const glm::vec2 part = zoom.high - zoom.low, whole = all.high - all.low;
    if (zoom.empty() || double(part.x * part.y) > mostOfMap * double(whole.x * whole.y)) return std::nullopt;
    return zoom;
}

MapScene makeMapScene(const Study& study, ShadowMeasure measure, const LegendChoice& choice) {
    const ShadowField& field = fieldOfColumn(study.field, choice.trees);
    const ColourScale scale = coloursOf(makeLegend(field, measure, choice));
    return {study.city, study.settings.region, field.grid,
            [&study, &field, measure, scale](int wantedPixels) {
                return makeFieldImage(field, study.receivers, measure, scale, wantedPixels);
            }};
}

MapScene makeGrossScene(const City& city, const Region& region, const ShadowField& field,
                        const ColourScale& scale) {
    const auto image = [&field, scale](int wantedPixels) {
        const auto colour = [&](std::size_t cell) { return pickColour(scale, double(field.grossMin[cell])); };
        return makeColourImage(field.grid, colour, wantedPixels);
    };
    return {city, region, field.grid, image};
}

MapView makeMapView(const MapScene& scene, const QRectF& frame) { return {shownGround(scene), frame}; }

MapView makeMapView(const Study& study, const QRectF& frame) {
    return {worldOf(study.settings.region, study.field.grid), frame};
}

void paintMap(const Canvas& canvas, const MapView& view, const MapScene& scene, UnitSystem units) {
    const QPainterPath region = pathOf(scene.region, view);
    canvas.painter.save();
    canvas.painter.setClipRect(view.target());
    canvas.painter.fillRect(view.target(), ink::paper);
    if (scene.city.context)
        paintContext(canvas.painter, *scene.city.context, view.transform(), 0.4 * canvas.point);
    paintField(canvas, view, scene);
    canvas.painter.setRenderHint(QPainter::Antialiasing);
    if (scene.ground) scene.ground(canvas, view);
    paintCity(canvas, view, scene, region);
    if (scene.removed) paintBuildings(canvas, view, *scene.removed, demolishedStyle);
    if (scene.proposal) paintProposal(canvas, view, *scene.proposal, units);
    paintOutline(canvas, region);
    paintMarks(canvas, view, scene.marks);
    canvas.painter.restore();
    canvas.painter.setBrush(Qt::NoBrush);
    canvas.painter.setPen(linePen(canvas, ink::line, 0.6));
    canvas.painter.drawRect(view.target());
}

std::shared_ptr<const City> findAbsent(City onlyBefore, const City& after) {
    std::set<std::string_view> ids;
    for (const auto& building : after.buildings) ids.insert(building->sourceId);
    std::erase_if(onlyBefore.buildings,
                  [&](const auto& building) { return ids.contains(building->sourceId); });
    return onlyBefore.buildings.empty() ? nullptr : std::make_shared<const City>(std::move(onlyBefore));
}

void paintMap(const Canvas& canvas, const MapView& view, const Study& study, ShadowMeasure measure) {
    paintMap(canvas, view, makeMapScene(study, measure));
}

namespace {

bool showsOutline(const MapView& view, const Region& region) {
    const QPainterPath path = pathOf(region, view);
    return path.intersects(view.target()) && !path.contains(view.target());
}

// What the colours and lines mean, of those that are in sight.
QStringList listNotes(const MapView& view, const MapScene& scene) {
    const auto isSeen = [&](const auto& building) { return view.sees(bounds(*building)); };
    const auto isSeenProposal = [&](const auto& building) {
        return isProposal(*building) && isSeen(building);
    };
    QStringList notes;
    const bool hasProposal = scene.proposal && std::ranges::any_of(scene.proposal->buildings, isSeen);
    if (hasProposal || (!scene.fillOf && std::ranges::any_of(scene.city.buildings, isSeenProposal)))
        notes << sheetText("violet: proposed");
    const bool hasDesigned = scene.removed && std::ranges::any_of(scene.removed->buildings, isSeenProposal);
    if (hasDesigned)
        notes << sheetText("orange: only in the baseline");
    else if (scene.removed && std::ranges::any_of(scene.removed->buildings, isSeen))
        notes << sheetText("orange: demolished");
    if (showsOverhangs(view, scene.city)) notes << sheetText("dashed: open below");
    if (showsOutline(view, scene.region)) notes << sheetText("dark line: region");
    return notes;
}

// In one line where they fit, else in two, which end where the legend's numbers do.
void paintNotes(const Canvas& canvas, const QRectF& area, const QStringList& notes) {
    constexpr double notePt = 6.5, baselinePt = 32, linePt = 7.5;
    canvas.painter.setFont(textFont(canvas, notePt));
    canvas.painter.setPen(canvas.inks.quiet);
    const QString separator = QStringLiteral(", ");
    const QFontMetricsF metrics(canvas.painter.font(), canvas.painter.device());
    const bool isLong = metrics.horizontalAdvance(notes.join(separator)) > area.width();
    const qsizetype first = isLong ? (notes.size() + 1) / 2 : notes.size();
    const QStringList lines{notes.mid(0, first).join(separator), notes.mid(first).join(separator)};
    double baseline = baselinePt - (isLong ? linePt : 0);
    for (const QString& line : lines) {
        canvas.painter.drawText(QPointF(area.left(), area.top() + baseline * canvas.point), line);
        baseline += linePt;
    }
}

}  // namespace

void paintMapFoot(const Canvas& canvas, const QRectF& area, const MapView& view, const Legend& legend,
                  const MapScene& scene, UnitSystem units) {
    const double point = canvas.point;
    const double arrowWidth = 16 * point;
    const double barRoom = std::min(area.width() * 0.3, 140 * point);
    const double legendWidth = area.width() - arrowWidth - barRoom - 30 * point;
    paintLegend(canvas, {area.left(), area.top(), legendWidth, area.height()}, legend);
    paintNorthArrow(canvas, {area.right() - arrowWidth, area.top(), arrowWidth, area.height()});
    const QRectF barArea(area.right() - arrowWidth - 10 * point - barRoom, area.top(), barRoom,
                         area.height());
    const double longestM = (barRoom - 20 * point) / view.unitsPerM();
    paintScaleBar(canvas, barArea, scaleBarWithin(longestM, units), view.unitsPerM());
    paintNotes(canvas, barArea, listNotes(view, scene));
}

}  // namespace noonmark
