#include "core/city/map_context.h"
#include "scenarios/project/read_project.h"
#include "scenarios/project/tables/checked_row.h"
#include "scenarios/project/tables/geometry_blob.h"
#include "scenarios/project/tables/geopackage.h"
#include "scenarios/project/write_project.h"

// Reads and writes the table `context`: what maps draw for orientation. All trees are one feature.
namespace noonmark {

namespace {

constexpr const char* attributionKey = "context_attribution";
constexpr NumberLimits widthLimitsM{0, 1000};

Box2 boxOf(const MapContext& context) {
    Box2 box;
    for (const ContextArea& area : context.areas)
        for (const Footprint& polygon : area.polygons) box.add(bounds(polygon));
    for (const ContextLine& line : context.lines)
        for (const glm::vec2 point : line.points) box.add(point);
    for (const glm::vec2 tree : context.trees) box.add(tree);
    return box;
}

void readLine(const Statement& row, ContextKind kind, MapContext& context) {
    const CheckedRow checked(row, "context");
    auto points = toPoints(row.blob(1));
    if (!points) checked.refuse("the shape is not valid");
    if (kind == ContextKind::tree)
        context.trees.insert(context.trees.end(), points->begin(), points->end());
    else if (points->size() > 1)
        context.lines.push_back({kind, row.text(3),
                                 row.isNull(4) ? 2.0F : float(checked.number(4, "width_m", widthLimitsM)),
                                 *std::move(points)});
}

}  // namespace

void writeContext(Database& database, const MapContext* context) {
    database.execute("DELETE FROM context");
    setFact(database, attributionKey, context == nullptr ? std::string() : context->attribution);
    if (context == nullptr) return;
    Statement add = database.prepare("INSERT INTO context (geom, kind, name, width_m) VALUES (?, ?, ?, ?)");
    for (const ContextArea& area : context->areas)
        add.run(AsBlob{multiPolygonBlob(area.polygons)}, nameOf(area.kind), area.name,
                std::optional<double>{});
    for (const ContextLine& line : context->lines)
        add.run(AsBlob{lineBlob(line.points)}, nameOf(line.kind), line.name,
                std::optional<double>(line.widthM));
    if (!context->trees.empty())
        add.run(AsBlob{multiPointBlob(context->trees)}, nameOf(ContextKind::tree), "",
                std::optional<double>{});
    const Box2 box = boxOf(*context);
    touchLayer(database, "context", double(box.low.x), double(box.low.y), double(box.high.x),
               double(box.high.y));
}

std::shared_ptr<const MapContext> readContext(Database& database) {
    auto context = std::make_shared<MapContext>();
    Statement row = database.prepare("SELECT fid, geom, kind, name, width_m FROM context ORDER BY fid");
    while (row.step()) {
        const auto kind = parseContextKind(row.text(2));
        if (!kind) continue;  // of a later version, or drawn in a GIS program
        if (auto polygons = toPolygons(row.blob(1)))
            context->areas.push_back({*kind, row.text(3), *std::move(polygons)});
        else
            readLine(row, *kind, *context);
    }
    context->attribution = readFact(database, attributionKey);
    return context->empty() ? nullptr : context;
}

}  // namespace noonmark
