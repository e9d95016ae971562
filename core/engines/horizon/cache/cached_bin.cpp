#include "core/engines/horizon/cache/cached_bin.h"

namespace noonmark {

HorizonCode* BaselineCodes::add(std::size_t block, std::size_t blocks) {
    pageOf_.resize(blocks, -1);
    pageOf_[block] = std::int32_t(blocks_.size());
    blocks_.push_back(std::uint32_t(block));
    codes_.resize(codes_.size() + ReceiverBlocks::cells);
    return page(block);
}

// The last page moves into the free place.
void BaselineCodes::remove(std::size_t block) {
    const std::int32_t free = pageOf_[block];
    const std::uint32_t last = blocks_.back();
    std::copy_n(page(last), ReceiverBlocks::cells, codes_.data() + start(free));
    blocks_[std::size_t(free)] = last;
    pageOf_[last] = free;
    pageOf_[block] = -1;
    blocks_.pop_back();
    codes_.resize(codes_.size() - ReceiverBlocks::cells);
}

void BaselineCodes::clear() { *this = {}; }

void BaselineCodes::setLowest(std::size_t block, std::size_t blocks, HorizonCode lowest) {
    lowest_.resize(blocks, unknown);
    lowest_[block] = lowest;
}

}  // namespace noonmark
