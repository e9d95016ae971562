#include <dl_dxf.h>

#include <filesystem>
#include <memory>

#include "core/io/bodies/write_bodies.h"

namespace noonmark {

namespace {

constexpr int metres = 6;  // $INSUNITS
constexpr int byLayer = 256;
constexpr int grey = 8, red = 1;

const char* layerOf(bool isProposed) { return isProposed ? "buildings_proposed" : "buildings"; }

// Without comments at its head by the library itself, which would name another program.
void writeHead(DL_Dxf& dxf, DL_WriterA& writer, const std::string& plane) {
    dxf.writeComment(writer, plane);
    writer.sectionHeader();
    writer.dxfString(9, "$ACADVER");
    writer.dxfString(1, "AC1009");
    writer.dxfString(9, "$INSUNITS");
    writer.dxfInt(70, metres);
    writer.sectionEnd();
}

void writeLayers(DL_Dxf& dxf, DL_WriterA& writer) {
    writer.sectionTables();
    writer.tableLayers(2);
    for (const bool isProposed : {false, true})
        dxf.writeLayer(writer, {layerOf(isProposed), 0},
                       {"", isProposed ? red : grey, -1, "CONTINUOUS", 1.0});
    writer.tableEnd();
    writer.sectionEnd();
}

// A triangle is a face whose last two corners are the same.
void writeFaces(DL_Dxf& dxf, DL_WriterA& writer, const Body& body) {
    const DL_Attributes look(layerOf(body.isProposed), byLayer, -1, "BYLAYER", 1.0);
    for (const glm::uvec3 triangle : body.triangles) {
        const glm::dvec3 a = body.vertices[triangle.x], b = body.vertices[triangle.y],
                         c = body.vertices[triangle.z];
        dxf.write3dFace(writer, {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, c.x, c.y, c.z}, look);
    }
}

}  // namespace

Result<void> writeBodiesDxf(const std::filesystem::path& file, const BodySet& set) {
    DL_Dxf dxf;
    const std::unique_ptr<DL_WriterA> writer(dxf.out(file.c_str(), DL_Codes::AC1009));
    if (!writer)
        return failure("The drawing cannot be written", file.string(),
                       "Check that the folder exists, is writable and has space");
    writeHead(dxf, *writer, set.plane);
    writeLayers(dxf, *writer);
    writer->sectionEntities();
    for (const Body& body : set.bodies) writeFaces(dxf, *writer, body);
    writer->sectionEnd();
    writer->dxfEOF();
    const bool written = !writer->openFailed();
    writer->close();
    if (written) return {};
    return failure("The drawing could not be written completely", file.string(),
                   "Check that the disk has free space");
}

}  // namespace noonmark
