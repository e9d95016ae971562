#include "app/gui/session/workbench.h"

#include "app/input/find_element_parts.h"

// Studies at points of Workbench: on facades, at windows, on a plane.
namespace noonmark {

// The number of points is known only once they are placed, so each run is estimated first.
void Workbench::startElements() {
    const auto elements = findElementParts(*document_.elements(), session_.project(), *session_.city());
    if (!elements) return tell(elements.error());
    running_.start<RunEstimate>(
        tr("Estimating"),
        [city = session_.city(), settings = document_.settings(), elements = *elements](
            Progress& progress, const std::stop_token& stop) {
            return estimateRun(*city, settings, elements, progress, stop);
        },
        [this](const Result<RunEstimate>& one) { announceIfLong(one, 1, [this] { measureElements(); }); });
}

void Workbench::measureElements() {
    const auto elements = findElementParts(*document_.elements(), session_.project(), *session_.city());
    if (!elements) return tell(elements.error());
    running_.start<ElementAnswer>(
        tr("Study"),
        [shown = city_, city = session_.city(), settings = document_.settings(), elements = *elements](
            Progress& progress, const std::stop_token& stop) {
            return elementsOf(withCity(shown->loaded, *city), settings, elements, progress, stop);
        },
        [this](Result<ElementAnswer> answer) { takeElements(std::move(answer)); });
}

void Workbench::takeElements(Result<ElementAnswer> answer) {
    if (!answer) {
        Q_EMIT studyStopped(isCancelled(answer.error()));
        return tell(answer.error());
    }
    answerSeconds_ = answer->study.seconds.at("total");
    standBack();
    elements_ = std::make_shared<const ElementAnswer>(*std::move(answer));
    Q_EMIT elementsDone();
}

}  // namespace noonmark
