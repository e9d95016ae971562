// Kernels of traced_view.cpp.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/engines/ray/pixel_block_hwy.cpp"
#include <hwy/foreach_target.h>

#include "core/engines/ray/traced_view.h"
#include "core/simd/kernel.h"

HWY_BEFORE_NAMESPACE();
namespace noonmark::HWY_NAMESPACE {

using Floats = LanesUpTo<float, HitPacket::lanes>;
using Words = hn::RebindToUnsigned<Floats>;
using FloatVec = hn::Vec<Floats>;
using WordVec = hn::Vec<Words>;

void aimRays(const PixelBlock& block, HitPacket& packet) {
    const Floats d;
    const hn::RebindToSigned<Floats> di;
    const auto spread = [&](float first, float right, float down, bool moves, HitPacket::Lanes& lanes) {
        for (std::size_t k = 0; k < HitPacket::lanes; k += hn::Lanes(d)) {
            const auto pixel = hn::Iota(di, int(k));
            const FloatVec column = hn::ConvertTo(d, hn::And(pixel, hn::Set(di, PixelBlock::sidePx - 1)));
            const FloatVec row = hn::ConvertTo(d, hn::ShiftRight<2>(pixel));
            const FloatVec aside =
                hn::Add(hn::Mul(column, hn::Set(d, right)), hn::Mul(row, hn::Set(d, down)));
            hn::Store(moves ? hn::Add(hn::Set(d, first), aside) : hn::Set(d, first), d, lanes.data() + k);
        }
    };
    const glm::vec3 &right = block.right, &down = block.down;
    spread(block.origin.x, right.x, down.x, block.parallel, packet.originX);
    spread(block.origin.y, right.y, down.y, block.parallel, packet.originY);
    spread(block.origin.z, right.z, down.z, block.parallel, packet.originZ);
    spread(block.direction.x, right.x, down.x, !block.parallel, packet.directionX);
    spread(block.direction.y, right.y, down.y, !block.parallel, packet.directionY);
    spread(block.direction.z, right.z, down.z, !block.parallel, packet.directionZ);
}

std::uint32_t endAtGround(float groundM, HitPacket& packet) {
    const Floats d;
    std::uint32_t ground = 0;
    for (std::size_t k = 0; k < HitPacket::lanes; k += hn::Lanes(d)) {
        const FloatVec height = hn::Sub(hn::Set(d, groundM), hn::Load(d, packet.originZ.data() + k));
        const FloatVec distance = hn::Div(height, hn::Load(d, packet.directionZ.data() + k));
        const FloatVec farthest = hn::Load(d, packet.distance.data() + k);
        const auto ends =
            hn::And(hn::Ge(distance, hn::Load(d, packet.from.data() + k)), hn::Lt(distance, farthest));
        hn::Store(hn::IfThenElse(ends, distance, farthest), d, packet.distance.data() + k);
        ground |= bitsOfMask(d, ends) << k;
    }
    return ground;
}

// A part of a unit vector from -1 to 1 as 0 to 254.
HWY_INLINE WordVec byteOf(FloatVec part) {
    const Floats d;
    const auto scaled = hn::Add(hn::Mul(part, hn::Set(d, 127.0F)), hn::Set(d, 127.5F));
    return hn::BitCast(Words{}, hn::ConvertTo(hn::RebindToSigned<Floats>{}, scaled));
}

void packPixels(const HitPacket& packet, std::uint32_t ground, bool cut, std::uint32_t* bits) {
    const Floats d;
    const Words du;
    const auto kindBits = [du](SeenKind kind) { return hn::Set(du, TracedPixel::bitsOf(kind)); };
    const WordVec seenBehind = kindBits(cut ? SeenKind::cut : SeenKind::building);
    for (std::size_t k = 0; k < HitPacket::lanes; k += hn::Lanes(d)) {
        const auto load = [d, k](const HitPacket::Lanes& lanes) { return hn::Load(d, lanes.data() + k); };
        const FloatVec x = load(packet.normalX), y = load(packet.normalY), z = load(packet.normalZ);
        const FloatVec towards =
            hn::Add(hn::Add(hn::Mul(x, load(packet.directionX)), hn::Mul(y, load(packet.directionY))),
                    hn::Mul(z, load(packet.directionZ)));
        const FloatVec square = hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
        const FloatVec scale = hn::Div(hn::Set(d, 1.0F), hn::Sqrt(hn::Max(square, hn::Set(d, 1e-30F))));
        const auto behind = hn::Gt(towards, hn::Zero(d));
        const FloatVec turn = hn::IfThenElse(behind, hn::Neg(scale), scale);
        const WordVec normal =
            hn::Or(hn::Or(byteOf(hn::Mul(x, turn)), hn::ShiftLeft<8>(byteOf(hn::Mul(y, turn)))),
                   hn::ShiftLeft<16>(byteOf(hn::Mul(z, turn))));
        const WordVec hit = hn::LoadU(du, packet.hit.data() + k);
        const auto atTerrain = hn::Eq(hit, hn::Set(du, HitPacket::terrain));
        const auto atNothing = hn::Eq(hit, hn::Set(du, HitPacket::nothing));
        const auto atGround = hn::RebindMask(du, maskOfBits(d, ground >> k));
        const WordVec building =
            hn::IfThenElse(hn::RebindMask(du, behind), seenBehind, kindBits(SeenKind::building));
        const WordVec found = hn::Or(normal, hn::IfThenElse(atTerrain, kindBits(SeenKind::ground), building));
        const WordVec missed =
            hn::IfThenElse(atGround, hn::Set(du, TracedPixel::levelGround), hn::Set(du, TracedPixel::sky));
        hn::StoreU(hn::Or(hn::IfThenElse(atNothing, missed, found), hn::Set(du, TracedPixel::ordinary)), du,
                   bits + k);
    }
}

HWY_INLINE FloatVec partOf(WordVec byte) {
    const Floats d;
    const auto whole = hn::BitCast(hn::RebindToSigned<Floats>{}, hn::And(byte, hn::Set(Words{}, 0xffU)));
    return hn::Mul(hn::Sub(hn::ConvertTo(d, whole), hn::Set(d, 127.0F)), hn::Set(d, 1 / 127.0F));
}

std::uint32_t turnToSun(glm::vec3 towardsSun, const std::uint32_t* bits, HitPacket& packet) {
    const Floats d;
    const Words du;
    // Away from the surface, so that no surface shades itself: float32 resolves some 1e-7 of the distance.
    const FloatVec minM = hn::Set(d, 0.02F), share = hn::Set(d, 1e-5F), grazing = hn::Set(d, 0.01F);
    std::uint32_t facing = 0;
    for (std::size_t k = 0; k < HitPacket::lanes; k += hn::Lanes(d)) {
        const WordVec word = hn::LoadU(du, bits + k);
        const FloatVec x = partOf(word), y = partOf(hn::ShiftRight<8>(word)),
                       z = partOf(hn::ShiftRight<16>(word));
        const FloatVec distance = hn::Load(d, packet.distance.data() + k);
        const FloatVec offset = hn::Add(minM, hn::Mul(share, distance));
        const auto move = [&](HitPacket::Lanes& origin, HitPacket::Lanes& direction, FloatVec normal,
                              float sun) {
            const FloatVec at =
                hn::Add(hn::Load(d, origin.data() + k), hn::Mul(hn::Load(d, direction.data() + k), distance));
            hn::Store(hn::Add(at, hn::Mul(normal, offset)), d, origin.data() + k);
            hn::Store(hn::Set(d, sun), d, direction.data() + k);
        };
        move(packet.originX, packet.directionX, x, towardsSun.x);
        move(packet.originY, packet.directionY, y, towardsSun.y);
        move(packet.originZ, packet.directionZ, z, towardsSun.z);
        const FloatVec towards =
            hn::Add(hn::Add(hn::Mul(x, hn::Set(d, towardsSun.x)), hn::Mul(y, hn::Set(d, towardsSun.y))),
                    hn::Mul(z, hn::Set(d, towardsSun.z)));
        const auto faces = hn::Gt(towards, grazing);  // never the sky, whose normal is 0
        hn::Store(hn::Zero(d), d, packet.from.data() + k);
        hn::Store(hn::IfThenElse(faces, hn::Set(d, 1e9F), hn::Set(d, -1.0F)), d, packet.distance.data() + k);
        facing |= bitsOfMask(d, faces) << k;
    }
    return facing;
}

}  // namespace noonmark::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace noonmark {

NOONMARK_KERNEL(aimRays);
NOONMARK_KERNEL(endAtGround);
NOONMARK_KERNEL(packPixels);
NOONMARK_KERNEL(turnToSun);

void aimRays(const PixelBlock& block, HitPacket& packet) { NOONMARK_CALL(aimRays)(block, packet); }

std::uint32_t endAtGround(float groundM, HitPacket& packet) {
    return NOONMARK_CALL(endAtGround)(groundM, packet);
}

void packPixels(const HitPacket& packet, std::uint32_t ground, bool cut, std::uint32_t* bits) {
    NOONMARK_CALL(packPixels)(packet, ground, cut, bits);
}

std::uint32_t turnToSun(glm::vec3 towardsSun, const std::uint32_t* bits, HitPacket& packet) {
    return NOONMARK_CALL(turnToSun)(towardsSun, bits, packet);
}

}  // namespace noonmark
#endif
