#pragma once

#include <memory>

#include "app/gui/base/layers/place_picture.h"
#include "app/questions/review_question.h"

namespace noonmark {

/// The reviewed places in the colours of their verdicts, for the view, with a legend of them. A parcel has
/// two reviews: the worse one colours it. Null for a null answer. Some 50 ms for 5,000 places.
std::shared_ptr<const PlaceView> makePlaceVerdicts(const std::shared_ptr<const ReviewAnswer>& answer);

}  // namespace noonmark
