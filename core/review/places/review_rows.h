#pragma once

#include "core/review/places/place_review.h"

namespace noonmark {

/// The figures of one day that every rule's table may show; `weight` is 1 and `criteria` empty.
ReviewRow computeReviewRow(const DayShadow& day, const DayClock& clock);

}  // namespace noonmark
