#pragma once

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEventLoop>

namespace noonmark::test {

/// Processes events until `condition` holds. Returns false if it does not within the limit, which is far
/// above the time needed.
template <class Condition>
bool waitFor(Condition condition, int limitMs = 60000) {
    QElapsedTimer clock;
    clock.start();
    while (!condition()) {
        if (clock.elapsed() > limitMs) return false;
        QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
    }
    return true;
}

}  // namespace noonmark::test
