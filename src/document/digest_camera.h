/* The digest of a camera move, for the kinds of objects that hold some. */
#ifndef BATTEN_DOCUMENT_DIGEST_CAMERA_H
#define BATTEN_DOCUMENT_DIGEST_CAMERA_H

#include <batten/camera.h>

uint64_t bat_digest_camera(uint64_t digest, const bat_camera *camera);

#endif
