#include "render/lab/depth_maps.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include "render/lab/gl_program.h"

namespace noonmark {

namespace {

constexpr std::size_t groupSize = 64;     // as in look_up.comp
constexpr std::size_t maxGroups = 65535;  // per dimension, guaranteed by the standard

/// A receiver in the layout of look_up.comp.
struct PackedReceiver {
    glm::vec4 place;
    glm::vec4 normal;
};

std::vector<PackedReceiver> packReceivers(const PlacedSurface& surface) {
    std::vector<PackedReceiver> all(surface.count);
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = {{surface.x[i], surface.y[i], surface.w[i], 0},
                  {surface.across[i], surface.up[i], surface.towards[i], 0}};
    return all;
}

template <class T>
void upload(GLenum target, GLuint buffer, const std::vector<T>& values) {
    glBindBuffer(target, buffer);
    glBufferData(target, GLsizeiptr(values.size() * sizeof(T)), values.data(), GL_STATIC_DRAW);
}

// Texel centres lie half a texel inside the map's border; clip space runs from -1 to 1.
glm::mat3 clipFromPlane(const MapFrame& frame) {
    glm::dmat3 clip(1);
    clip[0][0] = 2.0 / frame.columns, clip[2][0] = 1.0 / frame.columns - 1;
    clip[1][1] = 2.0 / frame.rows, clip[2][1] = 1.0 / frame.rows - 1;
    return glm::mat3(clip * frame.texelFromPlane);
}

}  // namespace

struct DepthMaps::Parts {
    GlProgram drawing, lookingUp;
    int columns, rows, layers;
    GlVertexArray vertexArray;
    GlBuffer vertices, indices, receivers, masks;
    GlTexture maps;
    GlFramebuffer framebuffer;

    MapFrame frame;
    AccrualSettings settings;
    std::size_t receiverCount = 0;
    double lowestW = 0, smallestQ = 1;
    GLsizei oneSided = 0, twoSided = 0;  // numbers of indices, in this order
    std::vector<glm::vec2> shears;
    std::vector<glm::vec3> suns;
    glm::vec2 depthRange{0, 1};
    GlWork work;

    void makeMaps() {
        glBindTexture(GL_TEXTURE_2D_ARRAY, maps);
        glTexStorage3D(GL_TEXTURE_2D_ARRAY, 1, GL_DEPTH_COMPONENT32F, columns, rows, layers);
        glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        glFramebufferTexture(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, maps, 0);
        glDrawBuffer(GL_NONE);
        glReadBuffer(GL_NONE);
    }

    // Covers only depths between the lowest receiver and the top: what lies below all receivers does not
    // matter.
    void setDepthRange(const IntervalCasters& casters) {
        double top = lowestW;
        for (const glm::dvec3 point : casters.points) top = std::max(top, point.z);
        const double room = 1 + double(settings.biasM);
        depthRange = {float((lowestW < 0 ? lowestW / smallestQ : lowestW) - room),
                      float((top > 0 ? top / smallestQ : top) + room)};
    }

    void setCommon(const GlProgram& program, int first, int count) const {
        program.use();
        glUniform1i(program.uniform("firstStep"), first);
        glUniform1i(program.uniform("steps"), count);
        glUniform2fv(program.uniform("shear"), GLsizei(shears.size()), glm::value_ptr(shears.front()));
        glUniform2f(program.uniform("depthRange"), depthRange.x, depthRange.y);
    }

    void drawTriangles(GLsizei first, GLsizei count, int steps) {
        if (count == 0) return;
        // OpenGL takes an offset into the bound buffer as a pointer.
        // NOLINTNEXTLINE(performance-no-int-to-ptr)
        const auto* offset = reinterpret_cast<const void*>(std::size_t(first) * sizeof(std::uint32_t));
        glDrawElementsInstanced(GL_TRIANGLES, count, GL_UNSIGNED_INT, offset, steps);
        ++work.drawCalls;
        work.vertices += std::uint64_t(count) * std::uint64_t(steps);
    }
};

DepthMaps::DepthMaps(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
DepthMaps::~DepthMaps() = default;

Result<std::unique_ptr<DepthMaps>> DepthMaps::make(const GlLimits& limits, int columns, int rows,
                                                   int layers) {
    auto drawing = drawingProgram(limits.layerInVertex);
    if (!drawing) return tl::make_unexpected(drawing.error());
    auto lookingUp = lookUpProgram();
    if (!lookingUp) return tl::make_unexpected(lookingUp.error());
    std::unique_ptr<Parts> parts(
        new Parts{std::move(*drawing), std::move(*lookingUp), columns, rows, layers});
    parts->makeMaps();
    if (const auto ok = checkGlErrors("depth maps"); !ok) return tl::make_unexpected(ok.error());
    return std::unique_ptr<DepthMaps>(new DepthMaps(std::move(parts)));
}

void DepthMaps::take(const MapFrame& frame, const PlacedSurface& receivers, const AccrualSettings& settings) {
    Parts& p = *parts_;
    p.frame = frame;
    p.settings = settings;
    p.receiverCount = receivers.count;
    p.lowestW = double(receivers.lowestW);
    p.smallestQ = 1e30;
    // q is linear and receivers lie on the map, so q is least at a corner of the map.
    const glm::dmat3 inverse = glm::inverse(frame.texelFromPlane);
    for (const glm::dvec2 corner :
         {glm::dvec2(-0.5, -0.5), glm::dvec2(frame.columns - 0.5, -0.5), glm::dvec2(-0.5, frame.rows - 0.5),
          glm::dvec2(frame.columns - 0.5, frame.rows - 0.5)})
        p.smallestQ = std::min(p.smallestQ, 1 / (inverse * glm::dvec3(corner, 1)).z);
    upload(GL_SHADER_STORAGE_BUFFER, p.receivers, packReceivers(receivers));
    upload(GL_SHADER_STORAGE_BUFFER, p.masks, std::vector<ShadowMask>(receivers.count));
}

void DepthMaps::take(const IntervalCasters& casters, const SunInterval& interval) {
    Parts& p = *parts_;
    std::vector<glm::vec3> points(casters.points.begin(), casters.points.end());
    std::vector<std::uint32_t> indices;
    const auto add = [&](bool twoSided) {
        for (const CasterFace& face : casters.faces) {
            if (face.twoSided != twoSided) continue;
            for (std::size_t i = 2; i < face.corners; ++i)
                indices.insert(indices.end(), {face.corner[0], face.corner[i - 1], face.corner[i]});
        }
        return GLsizei(indices.size());
    };
    p.oneSided = add(false);
    p.twoSided = add(true) - p.oneSided;
    p.shears.clear(), p.suns.clear();
    for (int step = 0; step < interval.steps; ++step) {
        p.shears.emplace_back(p.frame.shearOf(interval.at(step)));
        p.suns.emplace_back(p.frame.turned(interval.at(step)));
    }
    p.setDepthRange(casters);
    glBindVertexArray(p.vertexArray);
    upload(GL_ARRAY_BUFFER, p.vertices, points);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    upload(GL_ELEMENT_ARRAY_BUFFER, p.indices, indices);
}

void DepthMaps::draw(int first, int count) {
    Parts& p = *parts_;
    glBindFramebuffer(GL_FRAMEBUFFER, p.framebuffer);
    glViewport(0, 0, p.columns, p.rows);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_DEPTH_CLAMP);  // casters outside the depth range still cast shadows
    glDepthFunc(GL_GREATER);
    glClearDepth(0);
    glClear(GL_DEPTH_BUFFER_BIT);
    p.setCommon(p.drawing, first, count);
    const glm::mat3 clip = clipFromPlane(p.frame);
    glUniformMatrix3fv(p.drawing.uniform("clipFromPlane"), 1, GL_FALSE, glm::value_ptr(clip));
    glBindVertexArray(p.vertexArray);
    glEnable(GL_CULL_FACE);
    glCullFace(p.settings.side == CasterSide::towardsSun ? GL_BACK : GL_FRONT);
    p.drawTriangles(0, p.oneSided, count);
    glDisable(GL_CULL_FACE);
    p.drawTriangles(p.oneSided, p.twoSided, count);
    ++p.work.passes;
}

void DepthMaps::lookUp(int first, int count) {
    Parts& p = *parts_;
    const GlProgram& program = p.lookingUp;
    p.setCommon(program, first, count);
    const glm::mat3 texel(p.frame.texelFromPlane);
    const glm::dmat3 inverse = glm::inverse(p.frame.texelFromPlane);
    const double texelM = std::pow(std::abs(glm::determinant(p.frame.texelFromPlane)), -0.5);
    glUniformMatrix3fv(program.uniform("texelFromPlane"), 1, GL_FALSE, glm::value_ptr(texel));
    glUniform3f(program.uniform("perQ"), float(inverse[0][2]), float(inverse[1][2]), float(inverse[2][2]));
    glUniform3fv(program.uniform("sun"), GLsizei(p.suns.size()), glm::value_ptr(p.suns.front()));
    glUniform1f(program.uniform("bias"), p.settings.biasM);
    glUniform1f(program.uniform("slopeBias"), p.settings.slopeBias * float(texelM));
    glUniform1ui(program.uniform("receiverCount"), GLuint(p.receiverCount));
    glUniform1i(program.uniform("maps"), 0);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, p.maps);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, p.receivers);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, p.masks);
    const std::size_t groups = (p.receiverCount + groupSize - 1) / groupSize;
    const std::size_t across = std::min(groups, maxGroups);
    if (groups > 0) glDispatchCompute(GLuint(across), GLuint((groups + across - 1) / across), 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    p.work.lookups += std::uint64_t(p.receiverCount) * std::uint64_t(count);
}

void DepthMaps::wait() const { glFinish(); }

Result<void> DepthMaps::read(std::span<ShadowMask> masks) {
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, parts_->masks);
    glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, GLsizeiptr(masks.size_bytes()), masks.data());
    return checkGlErrors("shadow maps");
}

std::vector<float> DepthMaps::depths(int layer) const {
    const std::size_t size = std::size_t(parts_->columns) * std::size_t(parts_->rows);
    std::vector<float> all(size * std::size_t(parts_->layers));
    glBindTexture(GL_TEXTURE_2D_ARRAY, parts_->maps);
    glGetTexImage(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT, GL_FLOAT, all.data());
    const auto first = all.begin() + std::ptrdiff_t(size * std::size_t(layer));
    return {first, first + std::ptrdiff_t(size)};
}

const GlWork& DepthMaps::work() const { return parts_->work; }

}  // namespace noonmark
