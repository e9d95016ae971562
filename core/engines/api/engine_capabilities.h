#pragma once

#include <initializer_list>

namespace noonmark {

/// For which receivers an engine finds the same minutes whichever other receivers there are. Those that lay
/// maps over the whole region may not.
enum class Independence {
    none,
    onLevelGround,  ///< on terrain, heights are rounded from the lowest receiver up
    always,
};

/// What an engine can do. It is refused what it cannot do before it runs (Engine).
struct EngineCapabilities {
    bool terrain = false;        ///< takes cities with terrain, and receivers at heights of their own
    bool roofs = false;          ///< takes receivers on roofs
    bool overhangs = true;       ///< lets light through below parts with open air below them
    bool continuous = true;      ///< finds the longest unbroken run, too
    bool sets = false;           ///< sums minutes by sets of steps (months, weights) in one run
    bool attribution = false;    ///< and by building
    bool stepMasks = false;      ///< states which receivers are in shadow at each step (timelines of places)
    bool trees = false;          ///< weighs what crowns take from the sun (ShadowField::trees)
    bool cache = false;          ///< has a cache for edits (HorizonCache, ShadowCache)
    bool choosesEngine = false;  ///< computes nothing itself, but chooses another engine for each case
    Independence independence = Independence::none;
};

/// Of an engine that chooses one of these for each case: what any of them takes and sums, it does too; what
/// its result states, all of them must state.
constexpr EngineCapabilities combineForChoice(std::initializer_list<EngineCapabilities> engines) {
    EngineCapabilities choice{.choosesEngine = true};
    for (const EngineCapabilities& engine : engines) {
        choice.terrain |= engine.terrain;
        choice.roofs |= engine.roofs;
        choice.overhangs &= engine.overhangs;
        choice.continuous &= engine.continuous;
        choice.sets |= engine.sets;
        choice.attribution |= engine.attribution;
        choice.stepMasks |= engine.stepMasks;
        choice.trees |= engine.trees;
        choice.cache |= engine.cache;
    }
    return choice;
}

}  // namespace noonmark
