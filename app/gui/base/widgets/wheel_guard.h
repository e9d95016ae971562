#pragma once

#include <QObject>

class QApplication;

namespace noonmark {

/// Leaves the wheel to what scrolls: a number, date or list changes by it only while it has the focus, which
/// the wheel does not give. A slider that lies in a scrolling area likewise. One for the application, whose
/// widgets it all serves.
class WheelGuard final : public QObject {
    Q_OBJECT
public:
    explicit WheelGuard(QApplication& application);

    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace noonmark
