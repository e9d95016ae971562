#include "core/accumulate/projected/shadow_events.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>

namespace noonmark {

namespace {
// Words that one task walks through all steps: their cells' states, 12 bytes a cell, stay in the second-level
// cache.
constexpr std::size_t wordsATask = 128;
}  // namespace

ShadowEvents::ShadowEvents(const Receivers& receivers)
    : receivers_(receivers),
      layout_(receivers.grid),
      isReceiver_(layout_.words()),
      shaded_(layout_.words()),
      cells_(layout_.words() * 64) {
    for (const std::uint32_t cell : receivers.cells) {
        const int column = int(cell % std::uint32_t(layout_.columns)),
                  row = int(cell / std::uint32_t(layout_.columns));
        layout_.set(isReceiver_, column, row);
    }
}

void ShadowEvents::add(std::span<const std::uint64_t> rasters, std::span<const bool> startsRun) {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, layout_.words(), wordsATask),
        [&](const auto& range) { addWords(range.begin(), range.end(), rasters, startsRun); },
        tbb::simple_partitioner());
    steps_ += std::uint32_t(startsRun.size());
}

void ShadowEvents::addWords(std::size_t first, std::size_t end, std::span<const std::uint64_t> rasters,
                            std::span<const bool> startsRun) {
    for (std::size_t k = 0; k < startsRun.size(); ++k) {
        const std::uint32_t step = steps_ + std::uint32_t(k);
        const std::uint64_t* raster = rasters.data() + k * layout_.words();
        for (std::size_t word = first; word < end; ++word) {
            if (startsRun[k] && shaded_[word] != 0) change(word, 0, step);
            const std::uint64_t now = raster[word] & isReceiver_[word];
            if (now != shaded_[word]) change(word, now, step);
        }
    }
}

void ShadowEvents::change(std::size_t word, std::uint64_t now, std::uint32_t step) {
    const std::uint64_t before = shaded_[word];
    endRuns(word, before & ~now, step);
    for (std::uint64_t begun = now & ~before; begun != 0; begun &= begun - 1)
        cells_[word * 64 + std::size_t(std::countr_zero(begun))].start = step;
    shaded_[word] = now;
}

void ShadowEvents::endRuns(std::size_t word, std::uint64_t ended, std::uint32_t step) {
    for (; ended != 0; ended &= ended - 1) {
        CellState& cell = cells_[word * 64 + std::size_t(std::countr_zero(ended))];
        const std::uint32_t length = step - cell.start;
        cell.gross += length;
        cell.longest = std::max(cell.longest, length);
    }
}

void ShadowEvents::finish(ShadowField& field) {
    for (std::size_t word = 0; word < shaded_.size(); ++word) change(word, 0, steps_);
    for (const std::uint32_t cell : receivers_.cells) {
        const int column = int(cell % std::uint32_t(layout_.columns)),
                  row = int(cell / std::uint32_t(layout_.columns));
        const CellState& state = cells_[layout_.word(column, row) * 64 + std::size_t(column & 63)];
        field.grossMin[cell] = float(state.gross * field.stepMinutes / field.days);
        field.continuousMin[cell] = float(state.longest * field.stepMinutes);
    }
}

}  // namespace noonmark
