#pragma once

#include <QWidget>

#include "core/io/read_city.h"

class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace noonmark {

class FieldRows;

/// Reading settings, scale and rotation of a mesh being placed. The place itself is clicked in the view.
class PlacingPanel final : public QWidget {
    Q_OBJECT
public:
    explicit PlacingPanel(QWidget* parent = nullptr);

    void begin(const QString& file);
    /// Axes and unit that the file states cannot be chosen.
    void setStated(bool axes, bool unit);
    /// The mesh has a place, so it can be built. `groundElevationM`: of the ground under it, above the datum.
    void showPlaced(double heightM, double groundElevationM);
    void showWarnings(const Warnings& warnings);  ///< of reading the file
    [[nodiscard]] ReadSettings reading() const;
    [[nodiscard]] double scale() const;
    [[nodiscard]] double clockwiseDeg() const;
    [[nodiscard]] double storeyHeightM() const;  ///< 0: not known

Q_SIGNALS:
    void edited();
    void readingEdited();
    void applied();
    void cancelled();

private:
    QLabel* what_;
    QLabel* warnings_;
    FieldRows* axes_;
    QDoubleSpinBox* scale_;
    QDoubleSpinBox* turn_;
    QDoubleSpinBox* storeyHeight_;
    QPushButton* apply_;
    QString file_;
};

}  // namespace noonmark
