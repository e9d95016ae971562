#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "app/gui/base/jobs/job.h"
#include "app/gui/session/study/run_estimate.h"

class QTimer;

namespace noonmark {

/// How long the study would take, computed in the background once its settings rest for a moment.
class RunForecast final : public QObject {
    Q_OBJECT
public:
    explicit RunForecast(QObject* parent = nullptr);

    void setCity(std::shared_ptr<const City> city);  ///< null: no forecast
    /// `elements`: points are measured instead of cells.
    void setSettings(const StudySettings& settings, const std::optional<ElementSettings>& elements = {});

    /// Nothing while it is being computed, without a city, or where the study would be refused.
    [[nodiscard]] const std::optional<RunEstimate>& estimate() const { return estimate_; }
    [[nodiscard]] const QString& refusal() const { return refusal_; }  ///< why the study cannot run; or empty

Q_SIGNALS:
    void changed();

private:
    void askSoon();
    void ask();

    QTimer* rest_;
    std::shared_ptr<const City> city_;
    StudySettings settings_;
    std::optional<ElementSettings> elements_;
    std::optional<RunEstimate> estimate_;
    QString refusal_;
    JobSlot slot_;
};

}  // namespace noonmark
