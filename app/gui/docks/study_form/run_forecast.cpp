#include "app/gui/docks/study_form/run_forecast.h"

#include <QTimer>

namespace noonmark {

namespace {
constexpr int forecastRestMs = 300;
}

RunForecast::RunForecast(QObject* parent) : QObject(parent), rest_(new QTimer(this)) {
    rest_->setSingleShot(true);
    rest_->setInterval(forecastRestMs);
    connect(rest_, &QTimer::timeout, this, &RunForecast::ask);
}

void RunForecast::setCity(std::shared_ptr<const City> city) {
    if (city == city_) return;
    city_ = std::move(city);
    askSoon();
}

void RunForecast::setSettings(const StudySettings& settings, const std::optional<ElementSettings>& elements) {
    if (settings == settings_ && elements == elements_) return;
    settings_ = settings;
    elements_ = elements;
    askSoon();
}

void RunForecast::askSoon() {
    slot_.drop();
    estimate_.reset();
    refusal_.clear();
    Q_EMIT changed();
    rest_->start();
}

void RunForecast::ask() {
    if (!city_ || settings_.region.polygons.empty()) return;
    slot_.start<RunEstimate>(
        tr("Estimating"),
        [city = city_, settings = settings_, elements = elements_](Progress& progress,
                                                                   const std::stop_token& stop) {
            return elements ? estimateRun(*city, settings, *elements, progress, stop)
                            : estimateRun(*city, settings, stop);
        },
        [this](const Result<RunEstimate>& made) {
            if (made) estimate_ = *made;
            if (!made && !isCancelled(made.error())) refusal_ = QString::fromStdString(made.error().what);
            Q_EMIT changed();
        });
}

}  // namespace noonmark
