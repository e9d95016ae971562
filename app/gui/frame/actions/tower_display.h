#pragma once

#include <QObject>

class QAction;
class QSettings;

namespace noonmark {

class EditTools;

/// How proposed towers are shown: lines at their floors, heights above the ground or above the datum, and the
/// change while they are designed (on at first). The switches are remembered in the settings.
class TowerDisplay final : public QObject {
    Q_OBJECT
public:
    TowerDisplay(QSettings& settings, EditTools& tools);  ///< both outlive it

    [[nodiscard]] QAction* storeyLines() const { return storeyLines_; }  ///< checkable
    [[nodiscard]] QAction* aboveDatum() const { return aboveDatum_; }    ///< checkable

private:
    void setStoreyLines(bool on);
    void setAboveDatum(bool on);

    QSettings& settings_;
    EditTools& tools_;
    QAction* storeyLines_;
    QAction* aboveDatum_;
};

}  // namespace noonmark
