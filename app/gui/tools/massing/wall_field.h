#pragma once

#include <QWidget>

#include "scenarios/massing/massing.h"

class QDoubleSpinBox;

namespace noonmark {

/// Taper and twist of one volume, side by side.
class WallField final : public QWidget {
    Q_OBJECT
public:
    explicit WallField(QWidget* parent = nullptr);

    [[nodiscard]] WallShape walls() const;
    void show(const WallShape& walls);  ///< without a signal
    [[nodiscard]] QDoubleSpinBox* taperBox() const { return taper_; }
    [[nodiscard]] QDoubleSpinBox* twistBox() const { return twist_; }

Q_SIGNALS:
    void edited();

private:
    QDoubleSpinBox* taper_;
    QDoubleSpinBox* twist_;
};

/// The two fields alone, for tables: percent and degrees.
QDoubleSpinBox* taperField();
QDoubleSpinBox* twistField();

}  // namespace noonmark
