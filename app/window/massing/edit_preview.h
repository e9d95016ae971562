#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "app/window/job_slot.h"
#include "app/window/massing/live_shadow.h"
#include "scenarios/edits/apply_edits.h"

namespace noonmark {

struct OpenCity;
class ViewPanel;

/// Shows what edits would make of the city before they are made: what goes is gone, what comes stands there
/// in another colour, and where the ground is level its shadow follows. The city's own arrays stay as they
/// are.
class EditPreview final : public QObject {
    Q_OBJECT
public:
    explicit EditPreview(ViewPanel& panel, QObject* parent = nullptr);  ///< `panel` outlives it

    void setCity(std::shared_ptr<const OpenCity> city);  ///< ends the preview
    void setPeriod(const Period& period, const Observer& observer);

    /// In place of the edits before. Error: they cannot be applied; nothing changes then.
    Result<void> show(const std::vector<Edit>& edits);
    void clear();
    [[nodiscard]] bool shown() const { return shown_; }
    /// What is there by the edits that are shown.
    [[nodiscard]] const CityChanges& changes() const { return changes_; }

private:
    void hide(const std::vector<std::shared_ptr<const Building>>& removed);
    void prepareShadow();
    void showShadow();

    ViewPanel& panel_;
    std::shared_ptr<const OpenCity> city_;
    CityChanges changes_;
    bool shown_ = false;
    Period period_;
    Observer observer_;
    std::shared_ptr<LiveShadow> shadow_;  ///< null: not there yet, or not for this city
    JobSlot slot_;
};

}  // namespace noonmark
