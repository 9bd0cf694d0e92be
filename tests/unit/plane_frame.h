/* A plane frame whose members do not stretch: sways, one a floor, and rotations, one a joint; the rotations condensed. */
#pragma once

/* `lines` columns side by side, clamped in the ground, beams between them; one line: a wall. */
struct plane_frame {
    int storeys, lines;
    double height_m, bay_m, column_nm2, beam_nm2; /* EI of one member */
};

/* Lateral stiffness (storeys x storeys), K_ss - K_sr K_rr^-1 K_rs. */
void plane_frame_stiffness(const struct plane_frame *frame, double *k);
/* That of the shipped frame-beside-wall: the frames of the one building together, and the walls of the other. */
extern const struct plane_frame plane_frame_shipped, plane_wall_shipped;
