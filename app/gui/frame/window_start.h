#pragma once

#include <QObject>
#include <memory>

class QApplication;
class QSettings;

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

/// Selects Qt3D's OpenGL renderer, which is the faster one on software OpenGL, and keeps other widgets from
/// covering its window. Call it before QApplication is created.
void chooseRenderer();

/// Sets application name, style, palette, language and units: the same look on every desktop, light or dark
/// as the desktop is while the window is open, or as the user chose.
void applyAppearance(QApplication& application);

class MainWindow;

/// Owns the main window. Where language or units become others, makes another window around the same work,
/// as texts that are shown do not change by themselves: every text, table, scale and field is then new.
class WindowRenewal final : public QObject {
    Q_OBJECT
public:
    explicit WindowRenewal(QSettings& settings);  ///< `settings` must outlive it
    ~WindowRenewal() override;

    [[nodiscard]] MainWindow& window() { return *window_; }  ///< until it is renewed

Q_SIGNALS:
    void renewed();  ///< window() is another one

private:
    void renew();
    void adopt(std::unique_ptr<MainWindow> window);

    QSettings& settings_;
    std::unique_ptr<MainWindow> window_;
};

}  // namespace noonmark
