#pragma once

#include "core/city/trees/tree_facts.h"
#include "core/geo/frame.h"

namespace noonmark {

/// A tree as a file has it.
struct ReadTree {
    LonLat place;
    TreeFacts facts;
};

}  // namespace noonmark
