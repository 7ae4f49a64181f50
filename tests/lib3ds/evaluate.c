/* The tracks of a .3ds file as lib3ds evaluates them: evaluate FILE FRAME...
 *
 * Prints node,track,frame,numbers for positions, rotations (a quaternion x, y, z, w) and scales of objects, and for
 * positions of cameras and targets. */
#include <lib3ds/file.h>
#include <lib3ds/node.h>
#include <lib3ds/tracks.h>
#include <stdio.h>
#include <stdlib.h>

static void print_vectors(const char* node, const char* track, Lib3dsLin3Track* of, int count, char** frames) {
  if (of->keyL == NULL) return;
  for (int i = 0; i < count; ++i) {
    Lib3dsVector p;
    lib3ds_lin3_track_eval(of, p, (Lib3dsFloat)atof(frames[i]));
    printf("%s,%s,%s,%.9g,%.9g,%.9g\n", node, track, frames[i], p[0], p[1], p[2]);
  }
}

int main(int argc, char** argv) {
  Lib3dsFile* const file = argc > 1 ? lib3ds_file_load(argv[1]) : NULL;
  if (file == NULL) return 1;
  for (Lib3dsNode* node = file->nodes; node != NULL; node = node->next) {
    if (node->type == LIB3DS_CAMERA_NODE) {
      print_vectors(node->name, "position", &node->data.camera.pos_track, argc - 2, argv + 2);
    } else if (node->type == LIB3DS_TARGET_NODE) {
      print_vectors(node->name, "target", &node->data.target.pos_track, argc - 2, argv + 2);
    } else if (node->type == LIB3DS_OBJECT_NODE) {
      Lib3dsObjectData* const object = &node->data.object;
      print_vectors(node->name, "position", &object->pos_track, argc - 2, argv + 2);
      print_vectors(node->name, "scale", &object->scl_track, argc - 2, argv + 2);
      for (int i = 2; i < argc && object->rot_track.keyL != NULL; ++i) {
        Lib3dsQuat q;
        lib3ds_quat_track_eval(&object->rot_track, q, (Lib3dsFloat)atof(argv[i]));
        printf("%s,rotation,%s,%.9g,%.9g,%.9g,%.9g\n", node->name, argv[i], q[0], q[1], q[2], q[3]);
      }
    }
  }
  lib3ds_file_free(file);
  return 0;
}
