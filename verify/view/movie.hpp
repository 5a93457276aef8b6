// Frames as a movie, made by ffmpeg.
#pragma once

#include <filesystem>

#include "verify/view/colouring.hpp"
#include "verify/view/frames.hpp"
#include "verify/view/view_source.hpp"

namespace gpf {

constexpr int movie_frames_per_second = 30;

/// Throws InputError when the name ends neither in .mp4 nor in .gif, StorageError when ffmpeg cannot be started.
void require_movie_maker(const std::filesystem::path& path);

/// Runs the frames and writes them, atomically. `shown` is told how many frames are done. Throws StorageError when
/// ffmpeg fails, and what run_frames throws.
void write_movie(const ViewSource& source, const FramePlan& plan, Colouring colouring,
                 const std::filesystem::path& path, const std::function<void(int)>& shown);

}  // namespace gpf
