#include "core/mesh_reader/read_scene.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>
#include <map>

#include "core/mesh_reader/dxf_shapes.h"

namespace noonmark {

namespace {

constexpr int deepestInsert = 16;               // blocks in blocks
constexpr std::size_t maxPolygons = 5'000'000;  // blocks can repeat each other without end
constexpr std::size_t maxInserts = 1'000'000;

struct LayeredShape {
    std::string layer;
    std::vector<DxfPolygon> polygons;
};

struct Insert {
    std::string block;
    std::string layer;
    glm::dmat4 place{1};
};

/// The drawing itself, or a block of it.
struct DxfBlock {
    glm::dvec3 base{0};
    std::vector<LayeredShape> shapes;
    std::vector<LayeredShape> outlines;  // closed ones without a thickness
    std::vector<Insert> inserts;
};

// Its place and those of its rows and columns; none where there are too many.
std::vector<Insert> parseInserts(const DxfEntity& entity) {
    constexpr int mostRepeated = 10'000;
    const int columns = std::max(1, entity.whole(70, 1)), rows = std::max(1, entity.whole(71, 1));
    if (columns > mostRepeated || rows > mostRepeated || columns * rows > mostRepeated) return {};
    const glm::dmat4 axes(ownAxes(entity));
    glm::dmat4 place = glm::translate(axes, entity.point(10));
    place = glm::rotate(place, glm::radians(entity.number(50)), glm::dvec3(0, 0, 1));
    const glm::dvec3 scale(entity.number(41, 1), entity.number(42, 1), entity.number(43, 1));
    std::vector<Insert> inserts;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const glm::dvec3 step(column * entity.number(44), row * entity.number(45), 0);
            inserts.push_back(
                {entity.text(2), entity.text(8), glm::scale(glm::translate(place, step), scale)});
        }
    return inserts;
}

// Solids, regions and surfaces are stored in the format of a modeller (ACIS), which only CAD programs read.
bool isAcis(const std::string& type) {
    return type == "3DSOLID" || type == "BODY" || type == "REGION" || type.ends_with("SURFACE");
}

/// Reads sections; remembers what was left out, by reason.
class DxfDocument {
public:
    explicit DxfDocument(std::istream& stream) : reader_(stream) {}

    void read() {
        std::string section;
        for (auto entity = reader_.next(); entity; entity = takeEntity(*entity, section)) {
        }
    }

    [[nodiscard]] const DxfBlock& drawing() const { return drawing_; }
    [[nodiscard]] const DxfBlock* block(const std::string& name) const {
        const auto found = blocks_.find(name);
        return found == blocks_.end() ? nullptr : &found->second;
    }
    [[nodiscard]] const std::map<std::string, std::size_t>& leftOut() const { return leftOut_; }

private:
    // Returns the entity after this one.
    std::optional<DxfEntity> takeEntity(const DxfEntity& entity, std::string& section) {
        if (entity.type == "SECTION") section = entity.text(2);
        if (entity.type == "ENDSEC") section.clear();
        if (section == "BLOCKS" && entity.type == "BLOCK") {
            into_ = &blocks_[entity.text(2)];
            into_->base = entity.point(10);
        } else if (entity.type == "ENDBLK" || entity.type == "SECTION") {
            into_ = &drawing_;
        } else if (section == "ENTITIES" || section == "BLOCKS") {
            return takeShape(entity);
        }
        return reader_.next();
    }

    std::optional<DxfEntity> takeShape(const DxfEntity& entity) {
        if (entity.type == "POLYLINE") return takePolyline(entity);
        if (entity.whole(67) == 1)  // of a sheet
            return reader_.next();
        if (entity.type == "INSERT")
            addInserts(parseInserts(entity));
        else if (entity.type == "3DFACE")
            add(entity, makeFace(entity));
        else if (entity.type == "SOLID" || entity.type == "TRACE")
            add(entity, makeSolid(entity));
        else if (entity.type == "LWPOLYLINE")
            add(entity, makeLightOutline(entity));
        else if (entity.type == "MESH")
            add(entity, makeSubdivisionMesh(entity));
        else if (isAcis(entity.type))
            ++leftOut_["ACIS solids, " + entity.type];
        else if (entity.type != "ENDSEC" && entity.type != "ATTRIB" && entity.type != "SEQEND")
            ++leftOut_[entity.type];
        return reader_.next();
    }

    std::optional<DxfEntity> takePolyline(const DxfEntity& polyline) {
        std::vector<DxfEntity> vertices;
        auto entity = reader_.next();
        for (; entity && entity->type == "VERTEX"; entity = reader_.next()) vertices.push_back(*entity);
        if (polyline.whole(67) != 1) add(polyline, makePolyline(polyline, vertices));
        return entity;
    }

    void addInserts(const std::vector<Insert>& inserts) {
        if (inserts.empty()) ++leftOut_["blocks that are repeated more than 10,000 times"];
        into_->inserts.insert(into_->inserts.end(), inserts.begin(), inserts.end());
    }

    void add(const DxfEntity& entity, DxfShape shape) {
        if (!shape.leftOut.empty()) ++leftOut_[shape.leftOut];
        if (!shape.polygons.empty())
            into_->shapes.push_back({entity.text(8), std::move(shape.polygons)});
        else if (!shape.outline.empty())
            into_->outlines.push_back({entity.text(8), {std::move(shape.outline)}});
    }

    DxfReader reader_;
    DxfBlock drawing_;
    std::map<std::string, DxfBlock> blocks_;
    DxfBlock* into_ = &drawing_;
    std::map<std::string, std::size_t> leftOut_;
};

/// Collects the polygons of each layer, those of inserted blocks at their place.
class LayerMeshes {
public:
    LayerMeshes(const DxfDocument& document, std::vector<LayeredShape> DxfBlock::*shapes)
        : document_(document), shapes_(shapes) {}

    // False: there are too many.
    bool add(const DxfBlock& block, const glm::dmat4& place, const std::string& layer, int depth) {
        for (const LayeredShape& shape : block.*shapes_) addShape(shape, place, layer);
        if (depth >= deepestInsert || count_ > maxPolygons) return false;
        for (const Insert& insert : block.inserts) {
            const DxfBlock* inserted = document_.block(insert.block);
            if (!inserted) continue;
            if (++inserts_ > maxInserts) return false;
            const glm::dmat4 there = glm::translate(place * insert.place, -inserted->base);
            // In a block, layer 0 means the layer of what inserts it.
            if (!add(*inserted, there, insert.layer == "0" ? layer : insert.layer, depth + 1)) return false;
        }
        return true;
    }

    [[nodiscard]] const std::map<std::string, MeshPiece>& layers() const { return layers_; }

private:
    void addShape(const LayeredShape& shape, const glm::dmat4& place, const std::string& layer) {
        MeshPiece& piece = layers_[shape.layer == "0" && !layer.empty() ? layer : shape.layer];
        for (const DxfPolygon& polygon : shape.polygons) {
            piece.cornerCounts.push_back(std::uint32_t(polygon.size()));
            for (const glm::dvec3 corner : polygon) {
                piece.corners.push_back(std::uint32_t(piece.points.size()));
                addPoint(piece, glm::dvec3(place * glm::dvec4(corner, 1)));
            }
            ++count_;
        }
    }

    const DxfDocument& document_;
    std::vector<LayeredShape> DxfBlock::*shapes_;
    std::map<std::string, MeshPiece> layers_;
    std::size_t count_ = 0, inserts_ = 0;
};

std::string describeLeftOut(const std::map<std::string, std::size_t>& leftOut) {
    std::string text;
    for (const auto& [what, count] : leftOut)
        text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", what, count);
    return text;
}

std::string headOf(const std::filesystem::path& file, std::size_t bytes) {
    std::string head(bytes, '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.read(head.data(), std::streamsize(bytes));
    head.resize(std::size_t(stream.gcount()));
    return head;
}

constexpr std::string_view binaryHead = "AutoCAD Binary DXF";

}  // namespace

bool isDxf(const std::filesystem::path& file) {
    constexpr std::size_t headBytes = 4096;
    if (headOf(file, headBytes).starts_with(binaryHead)) return true;
    std::ifstream stream(file, std::ios::binary);
    const auto first = DxfReader(stream).next();
    return first && first->type == "SECTION";
}

Result<void> readDxf(const std::filesystem::path& file, const std::function<void(const MeshObject&)>& take) {
    if (headOf(file, binaryHead.size()) == binaryHead)
        return failure("The DXF is in binary form", file.string(), "Save it as an ASCII DXF");
    std::ifstream stream(file, std::ios::binary);
    DxfDocument document(stream);
    document.read();
    LayerMeshes masses(document, &DxfBlock::shapes), outlines(document, &DxfBlock::outlines);
    if (!masses.add(document.drawing(), glm::dmat4(1), {}, 0) ||
        (masses.layers().empty() && !outlines.add(document.drawing(), glm::dmat4(1), {}, 0)))
        return failure("Blocks of the DXF insert each other too often", file.string(),
                       "Explode the blocks of the masses, and export these alone");
    const std::string leftOut = describeLeftOut(document.leftOut());
    if (masses.layers().empty() && outlines.layers().empty())
        return failure(
            "The DXF holds no mass" + (leftOut.empty() ? leftOut : ", only " + leftOut), file.string(),
            "Draw masses as 3D faces, meshes or closed outlines with a thickness; convert 3D solids "
            "to meshes (CONVTOMESH, or 3DSOUT)");
    for (const auto& [layer, piece] : masses.layers()) take({layer, {piece}});
    for (const auto& [layer, piece] : outlines.layers())
        take({.name = layer, .pieces = {piece}, .kind = MeshObject::Kind::outlines});
    for (const auto& [what, count] : document.leftOut())
        take({{}, {}, {}, fmt::format("{} ({})", what, count)});
    return {};
}

}  // namespace noonmark
