slender:
.LFB3641:
	pushq	%rbp
	movq	%rdx, %rax
	movl	$255, %edx
	vmovd	%edx, %xmm0
	vpbroadcastw	%xmm0, %ymm0
	movq	%rsp, %rbp
	pushq	%r15
	pushq	%r14
	pushq	%r13
	pushq	%r12
	pushq	%rbx
	andq	$-32, %rsp
	subq	$704, %rsp
	vpbroadcastd	(%rcx), %ymm1
	movl	(%rsi), %edx
	movl	(%r9), %r14d
	movq	%rcx, 584(%rsp)
	movl	(%rax), %ecx
	movl	4(%rsi), %esi
	movl	%edx, %r12d
	movl	%edx, %r13d
	movl	4(%rax), %eax
	movq	%rdi, 160(%rsp)
	vpand	%ymm1, %ymm0, %ymm0
	vpsrlw	$8, %ymm1, %ymm6
	cmpl	%edx, %ecx
	movq	%rdi, 576(%rsp)
	movl	%esi, %r11d
	movl	%esi, %ebx
	cmovle	%ecx, %r12d
	cmovge	%ecx, %r13d
	movl	%r14d, %edi
	cmpl	%esi, %eax
	cmovle	%eax, %r11d
	cmovge	%eax, %ebx
	movq	%r9, 256(%rsp)
	movl	12(%r8), %r9d
	vmovdqa	%ymm0, 608(%rsp)
	sarl	$8, %edi
	movl	%r12d, %r10d
	addl	$5, %edi
	sarl	$8, %r10d
	movl	%r9d, 416(%rsp)
	vmovdqa	%ymm6, 640(%rsp)
	subl	%edi, %r10d
	movl	%r10d, %r15d
	movl	%r10d, 192(%rsp)
	movl	%r13d, %r10d
	vmovdqa	%ymm1, 672(%rsp)
	sarl	$8, %r10d
	addl	%edi, %r10d
	movl	%r10d, 316(%rsp)
	movl	%r11d, %r10d
	sarl	$8, %r10d
	subl	%edi, %r10d
	movl	%r10d, 352(%rsp)
	movl	%ebx, %r10d
	sarl	$8, %r10d
	addl	%r10d, %edi
	movl	(%r8), %r10d
	movl	%edi, 320(%rsp)
	movl	8(%r8), %edi
	movl	%r10d, 384(%rsp)
	movl	4(%r8), %r10d
	cmpl	%edi, %r15d
	movl	%edi, 224(%rsp)
	movl	384(%rsp), %r9d
	setge	%dil
	xorl	%r15d, %r15d
	cmpl	%r9d, 316(%rsp)
	movl	416(%rsp), %r9d
	setl	%r15b
	movzbl	%dil, %edi
	addl	%edi, %r15d
	xorl	%edi, %edi
	cmpl	%r9d, 352(%rsp)
	setge	%dil
	addl	%r15d, %edi
	xorl	%r15d, %r15d
	cmpl	%r10d, 320(%rsp)
	setl	%r15b
	addl	%r15d, %edi
	jne	.L311
	movl	%r13d, %r9d
	subl	%r12d, %r9d
	sete	%dil
	subl	%r11d, %ebx
	movl	%r9d, 312(%rsp)
	sete	%r11b
	movl	%ebx, %r15d
	orb	%dil, %r11b
	jne	.L311
	cmpl	$131072, %ebx
	jg	.L311
	movl	$8192, %edi
	cmpl	%edi, %ebx
	cmovge	%ebx, %edi
	cmpl	%edi, %r9d
	setg	%r11b
	cmpl	$511, %r14d
	setg	%dil
	orb	%dil, %r11b
	movb	%r11b, 307(%rsp)
	je	.L314
.L311:
	vzeroupper
.L312:
	leaq	-40(%rbp), %rsp
	popq	%rbx
	popq	%r12
	popq	%r13
	popq	%r14
	popq	%r15
	popq	%rbp
	ret
.L314:
	cmpl	%ebx, %r9d
	jg	.L261
	movl	%edx, %edi
	movl	%esi, %edx
	movl	%edi, %esi
	movl	%ecx, %edi
	movl	%eax, %ecx
	movl	%edi, %eax
.L261:
	movl	%ecx, %edi
	movl	%eax, %r11d
	vxorps	%xmm4, %xmm4, %xmm4
	subl	%edx, %edi
	vcvtsi2ssl	%r14d, %xmm4, %xmm1
	subl	%esi, %r11d
	vmulss	.LC57(%rip), %xmm1, %xmm1
	movl	%edi, %r13d
	movl	%edi, %ebx
	movl	%r11d, %r9d
	sarl	$31, %r13d
	sarl	$31, %r9d
	movslq	%edi, %rdi
	xorl	%r13d, %ebx
	imulq	%rdi, %rdi
	movl	%r9d, 296(%rsp)
	subl	%r13d, %ebx
	vcvtsi2ssl	%ebx, %xmm4, %xmm10
	movl	%r9d, %ebx
	xorl	%r11d, %ebx
	movslq	%r11d, %r11
	imulq	%r11, %r11
	subl	%r9d, %ebx
	vcvtsi2ssl	%ebx, %xmm4, %xmm2
	movq	256(%rsp), %rbx
	addq	%r11, %rdi
	vcvtsi2ssq	%rdi, %xmm4, %xmm3
#APP
# 46 "/work/wC/include/irg/core/instructions.hpp" 1
	vsqrtss %xmm3, %xmm3, %xmm3
# 0 "" 2
#NO_APP
	vdivss	%xmm3, %xmm1, %xmm1
	vdivss	%xmm10, %xmm2, %xmm4
	vmulss	%xmm1, %xmm10, %xmm3
	vmulss	%xmm1, %xmm2, %xmm7
	vmovss	%xmm7, 292(%rsp)
	vdivss	%xmm2, %xmm10, %xmm10
	vmovss	%xmm4, 308(%rsp)
	vmulss	%xmm7, %xmm4, %xmm1
	vaddss	%xmm1, %xmm3, %xmm2
	cmpl	$1, 4(%rbx)
	vmovss	%xmm2, 300(%rsp)
	vunpcklps	%xmm7, %xmm2, %xmm2
	vunpcklps	%xmm10, %xmm4, %xmm1
	vmovlhps	%xmm2, %xmm1, %xmm1
	vmovaps	%xmm7, %xmm2
	vmovaps	%xmm1, 448(%rsp)
	jne	.L262
	vsubss	%xmm3, %xmm7, %xmm2
.L262:
	movl	296(%rsp), %r14d
	movl	%ecx, %r9d
	movl	%r13d, %ebx
	movl	%r13d, %edi
	vbroadcastss	.LC57(%rip), %xmm5
	xorl	%r13d, %r9d
	xorl	%edx, %edi
	movl	%r14d, %r11d
	movl	%r14d, %r12d
	subl	%r9d, %ebx
	movl	%r14d, %r9d
	xorl	%eax, %r11d
	xorl	%esi, %r9d
	vmovd	%ebx, %xmm4
	subl	%r13d, %edi
	vmulss	.LC6(%rip), %xmm2, %xmm2
	subl	%r11d, %r12d
	movl	%r14d, %r11d
	subl	%r14d, %r9d
	notl	%r11d
	vmovd	%r11d, %xmm7
	vpinsrd	$1, %r11d, %xmm7, %xmm1
	vmovd	%r14d, %xmm7
	vpinsrd	$1, %r14d, %xmm7, %xmm3
	vmovd	%r12d, %xmm7
	vmovss	%xmm2, 464(%rsp)
	vpunpcklqdq	%xmm1, %xmm3, %xmm14
	vpinsrd	$1, %r12d, %xmm7, %xmm1
	vmovd	%r9d, %xmm7
	vpinsrd	$1, %r9d, %xmm7, %xmm3
	vshufps	$0, %xmm2, %xmm2, %xmm2
	vmovdqa	%xmm14, 48(%rsp)
	movl	%r13d, %r9d
	vpunpcklqdq	%xmm1, %xmm3, %xmm7
	vpinsrd	$1, %ebx, %xmm4, %xmm1
	vmovd	%edi, %xmm4
	movl	$255, %ebx
	vpinsrd	$1, %edi, %xmm4, %xmm3
	vmovdqa	%xmm7, 32(%rsp)
	vshufps	$0, %xmm10, %xmm10, %xmm14
	movl	%r13d, %r12d
	vpunpcklqdq	%xmm1, %xmm3, %xmm4
	vmovd	%ebx, %xmm3
	movl	%r13d, %ebx
	vbroadcastss	308(%rsp), %xmm1
	vpshufd	$0, %xmm3, %xmm3
	vmovdqa	%xmm4, 16(%rsp)
	notl	%ebx
	vpand	%xmm4, %xmm3, %xmm4
	vpand	%xmm7, %xmm3, %xmm8
	vbroadcastss	292(%rsp), %xmm7
	vcvtdq2ps	%xmm4, %xmm4
	vmulps	%xmm5, %xmm4, %xmm4
	vcvtdq2ps	%xmm8, %xmm8
	vaddps	.LC60(%rip), %xmm4, %xmm4
	vmulps	%xmm5, %xmm8, %xmm8
	vxorps	%xmm5, %xmm5, %xmm5
	vmovaps	%xmm8, 256(%rsp)
	vmovss	.LC6(%rip), %xmm8
	vaddps	%xmm4, %xmm2, %xmm2
	vcvttps2dq	%xmm2, %xmm3
	vcvtdq2ps	%xmm3, %xmm3
	vaddps	.LC62(%rip), %xmm3, %xmm15
	vbroadcastss	.LC11(%rip), %xmm3
	vsubps	%xmm15, %xmm2, %xmm2
	vsubps	%xmm4, %xmm15, %xmm4
	vmovaps	%xmm15, 80(%rsp)
	vmulss	300(%rsp), %xmm8, %xmm15
	vmovaps	256(%rsp), %xmm8
	vaddps	.LC64(%rip), %xmm8, %xmm8
	vmulps	%xmm1, %xmm4, %xmm4
	vsubps	%xmm7, %xmm2, %xmm7
	vminps	%xmm3, %xmm2, %xmm9
	vshufps	$0, %xmm15, %xmm15, %xmm15
	vsubps	%xmm15, %xmm8, %xmm8
	vminps	%xmm3, %xmm7, %xmm7
	vsubps	%xmm9, %xmm3, %xmm13
	vaddps	%xmm4, %xmm8, %xmm8
	vmaxps	%xmm5, %xmm7, %xmm7
	vcvttps2dq	%xmm8, %xmm4
	vcvtdq2ps	%xmm4, %xmm4
	vsubps	%xmm4, %xmm8, %xmm8
	vmovaps	%xmm4, 96(%rsp)
	vmulps	%xmm1, %xmm9, %xmm4
	vsubps	%xmm7, %xmm9, %xmm11
	vsubps	%xmm9, %xmm2, %xmm9
	vaddps	%xmm8, %xmm4, %xmm4
	vmulps	%xmm1, %xmm2, %xmm2
	vsubps	%xmm7, %xmm3, %xmm12
	vaddps	%xmm8, %xmm2, %xmm2
	vmulps	%xmm14, %xmm9, %xmm9
	vmovaps	%xmm4, 256(%rsp)
	vmulps	%xmm1, %xmm7, %xmm7
	vbroadcastss	300(%rsp), %xmm4
	vaddps	%xmm8, %xmm4, %xmm4
	vaddps	%xmm9, %xmm2, %xmm8
	vmovss	.LC46(%rip), %xmm9
	vmulps	%xmm14, %xmm11, %xmm14
	vbroadcastss	.LC49(%rip), %xmm2
	vmulss	%xmm9, %xmm10, %xmm10
	vmulss	308(%rsp), %xmm9, %xmm9
	vaddps	%xmm7, %xmm4, %xmm4
	vmovaps	%xmm8, 144(%rsp)
	vmulps	%xmm1, %xmm13, %xmm7
	vmovaps	%xmm14, %xmm15
	vmulps	%xmm1, %xmm12, %xmm1
	vmovss	%xmm10, 288(%rsp)
	vmulps	%xmm2, %xmm12, %xmm12
	vshufps	$0, %xmm10, %xmm10, %xmm10
	vmovaps	%xmm10, 128(%rsp)
	vmulps	%xmm2, %xmm13, %xmm13
	vmulps	%xmm2, %xmm11, %xmm11
	vshufps	$0, %xmm9, %xmm9, %xmm9
	vmovaps	%xmm9, 112(%rsp)
	vmovaps	%xmm11, (%rsp)
	vsubps	256(%rsp), %xmm3, %xmm11
	vmovaps	%xmm12, %xmm9
	vsubps	%xmm4, %xmm3, %xmm12
	vsubps	%xmm8, %xmm3, %xmm3
	vmaxps	%xmm5, %xmm3, %xmm14
	vmaxps	%xmm5, %xmm11, %xmm8
	vmovaps	%xmm13, %xmm10
	vsubps	%xmm15, %xmm3, %xmm3
	vmaxps	%xmm5, %xmm12, %xmm13
	vsubps	%xmm7, %xmm11, %xmm11
	vsubps	%xmm1, %xmm12, %xmm12
	vminps	%xmm7, %xmm8, %xmm8
	vmaxps	%xmm5, %xmm3, %xmm2
	vminps	%xmm1, %xmm13, %xmm13
	vmulps	%xmm14, %xmm14, %xmm3
	vmaxps	%xmm5, %xmm12, %xmm12
	vmaxps	%xmm5, %xmm11, %xmm11
	vmulps	%xmm11, %xmm10, %xmm11
	vmulps	%xmm12, %xmm9, %xmm12
	vmulps	%xmm2, %xmm2, %xmm2
	vsubps	%xmm12, %xmm11, %xmm11
	vmulps	%xmm13, %xmm13, %xmm13
	vsubps	%xmm2, %xmm3, %xmm3
	vmulps	112(%rsp), %xmm3, %xmm3
	vmulps	%xmm8, %xmm8, %xmm8
	vsubps	%xmm13, %xmm8, %xmm8
	vmulps	128(%rsp), %xmm8, %xmm8
	vaddps	%xmm8, %xmm3, %xmm3
	vaddps	%xmm11, %xmm3, %xmm3
	vmovaps	%xmm3, 64(%rsp)
	vbroadcastss	.LC67(%rip), %xmm8
	vmovaps	256(%rsp), %xmm14
	vsubps	%xmm4, %xmm8, %xmm12
	vsubps	%xmm14, %xmm8, %xmm11
	vsubps	144(%rsp), %xmm8, %xmm8
	vmaxps	%xmm5, %xmm11, %xmm3
	vmaxps	%xmm5, %xmm12, %xmm13
	vmaxps	%xmm5, %xmm8, %xmm2
	vsubps	%xmm1, %xmm12, %xmm12
	vsubps	%xmm15, %xmm8, %xmm8
	vsubps	%xmm7, %xmm11, %xmm11
	vminps	%xmm7, %xmm3, %xmm3
	vminps	%xmm1, %xmm13, %xmm13
	vmaxps	%xmm5, %xmm12, %xmm12
	vmulps	%xmm2, %xmm2, %xmm2
	vmaxps	%xmm5, %xmm8, %xmm8
	vmaxps	%xmm5, %xmm11, %xmm11
	vmulps	%xmm12, %xmm9, %xmm12
	vmulps	%xmm11, %xmm10, %xmm11
	vmulps	%xmm8, %xmm8, %xmm8
	vmulps	%xmm13, %xmm13, %xmm13
	vmulps	%xmm3, %xmm3, %xmm3
	vsubps	%xmm8, %xmm2, %xmm2
	vmulps	112(%rsp), %xmm2, %xmm2
	vsubps	%xmm13, %xmm3, %xmm3
	vsubps	%xmm12, %xmm11, %xmm11
	vmulps	128(%rsp), %xmm3, %xmm3
	vbroadcastss	.LC69(%rip), %xmm12
	vaddps	%xmm3, %xmm2, %xmm2
	vsubps	%xmm4, %xmm12, %xmm13
	vaddps	%xmm11, %xmm2, %xmm2
	vsubps	%xmm14, %xmm12, %xmm11
	vsubps	144(%rsp), %xmm12, %xmm12
	vmaxps	%xmm5, %xmm13, %xmm14
	vsubps	%xmm1, %xmm13, %xmm13
	vmaxps	%xmm5, %xmm11, %xmm8
	vsubps	%xmm7, %xmm11, %xmm11
	vmaxps	%xmm5, %xmm12, %xmm3
	vsubps	%xmm15, %xmm12, %xmm12
	vminps	%xmm1, %xmm14, %xmm14
	vmaxps	%xmm5, %xmm13, %xmm13
	vminps	%xmm7, %xmm8, %xmm8
	vmaxps	%xmm5, %xmm11, %xmm11
	vmaxps	%xmm5, %xmm12, %xmm12
	vmulps	%xmm3, %xmm3, %xmm3
	vmulps	%xmm13, %xmm9, %xmm13
	vmulps	%xmm11, %xmm10, %xmm11
	vmulps	%xmm12, %xmm12, %xmm12
	vsubps	%xmm13, %xmm11, %xmm11
	vbroadcastss	.LC61(%rip), %xmm13
	vmulps	%xmm14, %xmm14, %xmm14
	vsubps	%xmm12, %xmm3, %xmm3
	vsubps	%xmm4, %xmm13, %xmm4
	vmulps	112(%rsp), %xmm3, %xmm3
	vmulps	%xmm8, %xmm8, %xmm8
	vsubps	%xmm14, %xmm8, %xmm8
	vmovdqa	48(%rsp), %xmm14
	vmulps	128(%rsp), %xmm8, %xmm8
	vaddps	%xmm8, %xmm3, %xmm3
	vaddps	%xmm11, %xmm3, %xmm11
	vbroadcastss	.LC6(%rip), %xmm3
	vmulps	%xmm3, %xmm1, %xmm1
	vsubps	%xmm1, %xmm4, %xmm4
	vmulps	%xmm3, %xmm15, %xmm1
	vsubps	144(%rsp), %xmm13, %xmm15
	vmulps	%xmm3, %xmm7, %xmm7
	vsubps	%xmm1, %xmm15, %xmm15
	vmulps	(%rsp), %xmm15, %xmm15
	vsubps	256(%rsp), %xmm13, %xmm1
	vsubps	%xmm7, %xmm1, %xmm1
	vmulps	%xmm9, %xmm4, %xmm4
	vmulps	%xmm10, %xmm1, %xmm7
	vmovaps	64(%rsp), %xmm1
	vmovdqa	32(%rsp), %xmm10
	vaddps	%xmm7, %xmm15, %xmm15
	vaddps	%xmm1, %xmm3, %xmm5
	vsubps	%xmm1, %xmm2, %xmm1
	vsubps	%xmm2, %xmm11, %xmm2
	vsubps	%xmm4, %xmm15, %xmm15
	vcvttps2dq	%xmm5, %xmm5
	vmovdqa	16(%rsp), %xmm4
	vaddps	%xmm3, %xmm2, %xmm2
	vaddps	%xmm3, %xmm1, %xmm1
	vpsrad	$8, %xmm4, %xmm4
	vsubps	%xmm11, %xmm15, %xmm15
	vmovd	%r13d, %xmm11
	vcvttps2dq	%xmm2, %xmm2
	vcvttps2dq	%xmm1, %xmm1
	vpinsrd	$1, %r13d, %xmm11, %xmm9
	vaddps	%xmm3, %xmm15, %xmm15
	vpslld	$16, %xmm2, %xmm3
	vpslld	$8, %xmm2, %xmm2
	vcvttps2dq	%xmm15, %xmm7
	vpslld	$24, %xmm7, %xmm8
	vpor	%xmm3, %xmm8, %xmm8
	vpslld	$8, %xmm1, %xmm3
	vpor	%xmm5, %xmm3, %xmm3
	vpslld	$16, %xmm1, %xmm1
	vpor	%xmm3, %xmm8, %xmm8
	vpslld	$24, %xmm5, %xmm5
	vpor	%xmm2, %xmm1, %xmm1
	vbroadcastss	.LC71(%rip), %xmm3
	vaddps	80(%rsp), %xmm3, %xmm3
	vpor	%xmm7, %xmm5, %xmm5
	vmovss	308(%rsp), %xmm2
	vmovss	.LC11(%rip), %xmm7
	vpor	%xmm5, %xmm1, %xmm1
	vmovss	300(%rsp), %xmm5
	vpxor	%xmm8, %xmm1, %xmm1
	vcvttps2dq	%xmm3, %xmm3
	vpaddd	%xmm4, %xmm3, %xmm3
	vmovd	%ebx, %xmm4
	vaddss	%xmm2, %xmm7, %xmm7
	vpunpckldq	%xmm4, %xmm4, %xmm4
	movl	$3, %ebx
	vpand	%xmm14, %xmm1, %xmm1
	vpunpcklqdq	%xmm4, %xmm9, %xmm9
	vpxor	%xmm8, %xmm1, %xmm1
	vbroadcastss	.LC73(%rip), %xmm4
	vaddps	96(%rsp), %xmm4, %xmm4
	vmovdqu	%xmm1, 500(%rsp)
	vpxor	%xmm9, %xmm3, %xmm3
	vpsrad	$8, %xmm10, %xmm9
	vmovdqu	%xmm3, 468(%rsp)
	vpextrd	$3, %xmm3, %r11d
	vcvttps2dq	%xmm4, %xmm4
	vpaddd	%xmm9, %xmm4, %xmm4
	vmovd	%ebx, %xmm9
	xorl	%r11d, %r12d
	vpextrd	$1, %xmm3, %ebx
	vpshufd	$0, %xmm9, %xmm9
	vpxor	%xmm14, %xmm4, %xmm4
	xorl	%ebx, %r9d
	vpand	%xmm14, %xmm9, %xmm9
	movl	%r9d, %edi
	addl	$1, %r9d
	vpsubd	%xmm9, %xmm4, %xmm4
	vmovdqu	%xmm4, 484(%rsp)
	notl	%edi
	vaddss	%xmm5, %xmm2, %xmm9
	addl	%r12d, %edi
	negl	%r12d
	testl	%r13d, %r13d
	cmove	%r9d, %r12d
	vcomiss	%xmm5, %xmm7
	movl	%edi, 520(%rsp)
	movl	%r12d, 516(%rsp)
	jb	.L265
	vmovss	.LC11(%rip), %xmm15
	vsubss	%xmm2, %xmm15, %xmm2
	vcomiss	%xmm2, %xmm5
	jnb	.L315
.L265:
	addl	%esi, %eax
	movl	$256, %r9d
	addl	%ecx, %edx
	vbroadcastss	.LC77(%rip), %xmm5
	movl	%eax, %esi
	andl	$511, %eax
	vmovss	.LC77(%rip), %xmm10
	movzbl	307(%rsp), %r14d
	vmovss	308(%rsp), %xmm14
	subl	%eax, %r9d
	sarl	$9, %esi
	vmovd	%r9d, %xmm2
	movl	%r12d, %r9d
	movb	%r14b, 524(%rsp)
	vpshufd	$0, %xmm2, %xmm2
	sall	$9, %r9d
	vpaddd	.LC75(%rip), %xmm2, %xmm2
	movl	%esi, 528(%rsp)
	addl	$256, %r9d
	subl	%edx, %r9d
	vcvtdq2ps	%xmm2, %xmm2
	movl	296(%rsp), %edx
	vmulps	%xmm5, %xmm2, %xmm15
	vxorps	%xmm2, %xmm2, %xmm2
	vmovaps	%xmm14, %xmm5
	vcvtsi2ssl	%r9d, %xmm2, %xmm2
	vmovups	%xmm15, 532(%rsp)
	vmulss	%xmm10, %xmm2, %xmm2
	vmovss	%xmm2, 548(%rsp)
	cmpl	%edx, %r13d
	je	.L269
	vxorps	.LC78(%rip), %xmm14, %xmm5
.L269:
	vmulss	%xmm5, %xmm2, %xmm8
	vxorps	%xmm14, %xmm14, %xmm14
	vmovss	%xmm5, 552(%rsp)
	vfnmadd132ss	.LC6(%rip), %xmm8, %xmm9
	vcvtsi2ssl	%eax, %xmm14, %xmm8
	vfmadd132ss	%xmm10, %xmm9, %xmm8
	vmovss	.LC80(%rip), %xmm9
	vaddss	.LC79(%rip), %xmm8, %xmm8
	vmulss	%xmm9, %xmm8, %xmm8
	vmulss	%xmm9, %xmm5, %xmm9
	vcvttss2sil	%xmm8, %edx
	vcvttss2sil	%xmm9, %r9d
	subl	$536870912, %edx
	cmpb	$0, 307(%rsp)
	movl	%edx, 556(%rsp)
	movl	%r9d, 560(%rsp)
	je	.L311
	cmpl	%r10d, 352(%rsp)
	movl	416(%rsp), %r14d
	setge	%cl
	cmpl	%r14d, 320(%rsp)
	movl	384(%rsp), %r14d
	setl	%al
	andl	%ecx, %eax
	cmpl	%r14d, 192(%rsp)
	setge	%cl
	testb	%cl, %al
	je	.L270
	movl	224(%rsp), %ecx
	cmpl	%ecx, 316(%rsp)
	jge	.L270
	movq	160(%rsp), %r14
	movq	16(%r14), %rcx
	movq	(%r14), %r14
	movq	%rcx, %rax
	andl	$3, %eax
	cmpl	%r15d, 312(%rsp)
	jg	.L271
	movslq	%r12d, %r12
	testq	%rax, %rax
	je	.L316
	movslq	%ebx, %rbx
	movl	$255, %eax
	vpbroadcastq	%xmm1, %ymm10
	movslq	%esi, %rsi
	imulq	%rcx, %r12
	vmovd	%eax, %xmm8
	vpextrd	$1, %xmm4, %eax
	vmovdqa	.LC12(%rip), %ymm14
	imulq	%rcx, %rbx
	cltq
	vpbroadcastw	%xmm8, %ymm8
	vmovdqa	%ymm14, 416(%rsp)
	vpshufb	%ymm14, %ymm10, %ymm10
	leaq	(%r12,%rsi,4), %r8
	vpand	%ymm8, %ymm10, %ymm10
	leaq	(%rbx,%rax,4), %rsi
	vmovd	%xmm3, %eax
	addq	%r14, %r8
	cltq
	addq	%r14, %rsi
	imulq	%rcx, %rax
	leaq	(%r14,%rax), %r10
.L273:
	vmovd	%xmm4, %eax
	vmovdqu	(%rsi), %xmm9
	movl	$255, %ebx
	movslq	%r11d, %r11
	cltq
	vmovd	%ebx, %xmm11
	movl	$128, %ebx
	vpsrldq	$8, %xmm1, %xmm1
	vmovdqu	(%r10,%rax,4), %xmm8
	vpbroadcastw	%xmm11, %ymm11
	vmovd	%ebx, %xmm13
	movl	$257, %ebx
	vpsubw	%ymm10, %ymm11, %ymm14
	vpbroadcastw	%xmm13, %ymm13
	vpbroadcastq	%xmm1, %ymm1
	vpshufb	416(%rsp), %ymm1, %ymm1
	vinserti128	$1, %xmm9, %ymm8, %ymm8
	vpsrlw	$8, %ymm8, %ymm12
	vpmullw	%ymm10, %ymm6, %ymm9
	vpand	%ymm8, %ymm11, %ymm8
	vpmullw	%ymm14, %ymm12, %ymm12
	vpmullw	%ymm10, %ymm0, %ymm10
	vpand	%ymm11, %ymm1, %ymm1
	vpmullw	%ymm14, %ymm8, %ymm8
	vpaddw	%ymm13, %ymm9, %ymm9
	vpaddw	%ymm9, %ymm12, %ymm9
	vmovd	%ebx, %xmm12
	vpaddw	%ymm13, %ymm10, %ymm10
	vpbroadcastw	%xmm12, %ymm12
	vpaddw	%ymm10, %ymm8, %ymm8
	vpextrd	$3, %xmm4, %ebx
	vpmulhuw	%ymm12, %ymm9, %ymm9
	vpmulhuw	%ymm12, %ymm8, %ymm8
	movslq	%ebx, %rbx
	vpsllw	$8, %ymm9, %ymm9
	vpor	%ymm8, %ymm9, %ymm9
	vmovdqu	%xmm9, (%r10,%rax,4)
	movq	160(%rsp), %rax
	vperm2i128	$17, %ymm9, %ymm9, %ymm9
	vpextrd	$2, %xmm3, %r10d
	vmovdqu	%xmm9, (%rsi)
	movslq	%r10d, %r10
	movq	16(%rax), %rsi
	movq	(%rax), %rax
	testb	$3, %sil
	je	.L317
	imulq	%rsi, %r11
	imulq	%r10, %rsi
	leaq	(%r11,%rbx,4), %r11
	addq	%rax, %r11
	addq	%rsi, %rax
.L275:
	vpextrd	$2, %xmm4, %esi
	vmovdqu	(%r11), %xmm3
	movl	$255, %r10d
	movslq	%esi, %rsi
	vpmullw	%ymm1, %ymm6, %ymm9
	vmovd	%r10d, %xmm4
	movl	$128, %r10d
	vmovdqu	(%rax,%rsi,4), %xmm10
	vpbroadcastw	%xmm4, %ymm4
	vmovd	%r10d, %xmm8
	movl	$257, %r10d
	vpsubw	%ymm1, %ymm4, %ymm11
	vpmullw	%ymm1, %ymm0, %ymm1
	vpbroadcastw	%xmm8, %ymm8
	vinserti128	$1, %xmm3, %ymm10, %ymm10
	vpsrlw	$8, %ymm10, %ymm3
	vpand	%ymm10, %ymm4, %ymm10
	vpmullw	%ymm11, %ymm3, %ymm3
	vpmullw	%ymm11, %ymm10, %ymm10
	vpaddw	%ymm8, %ymm9, %ymm9
	vpaddw	%ymm8, %ymm1, %ymm1
	vpaddw	%ymm3, %ymm9, %ymm3
	vmovd	%r10d, %xmm9
	vpaddw	%ymm10, %ymm1, %ymm1
	vpbroadcastw	%xmm9, %ymm9
	vpmulhuw	%ymm9, %ymm3, %ymm3
	vpmulhuw	%ymm9, %ymm1, %ymm1
	vpsllw	$8, %ymm3, %ymm3
	vpor	%ymm1, %ymm3, %ymm3
	vmovss	308(%rsp), %xmm1
	vmovdqu	%xmm3, (%rax,%rsi,4)
	vperm2i128	$17, %ymm3, %ymm3, %ymm3
	vmovdqu	%xmm3, (%r11)
	vmovss	300(%rsp), %xmm3
	vaddss	%xmm3, %xmm7, %xmm7
	vmulss	.LC6(%rip), %xmm7, %xmm7
	vsubss	.LC11(%rip), %xmm7, %xmm10
	vbroadcastss	%xmm10, %ymm10
	vsubss	%xmm1, %xmm7, %xmm11
	vbroadcastss	%xmm7, %ymm12
	vsubss	%xmm3, %xmm7, %xmm7
	vbroadcastss	%xmm7, %ymm7
	vbroadcastss	%xmm11, %ymm11
	vmovaps	%ymm7, 160(%rsp)
	vbroadcastss	%xmm1, %ymm7
	vmovaps	%xmm15, %xmm1
	vmovaps	%ymm7, 192(%rsp)
	vperm2f128	$0, %ymm1, %ymm1, %ymm15
	vbroadcastss	288(%rsp), %ymm7
	vmovaps	%ymm7, 224(%rsp)
	vbroadcastss	%xmm5, %ymm7
	vmovaps	%ymm7, 256(%rsp)
	testl	%edi, %edi
	jle	.L311
	vbroadcastss	.LC4(%rip), %ymm7
	leal	-2(%rdi), %esi
	leal	-1(%rdi), %eax
	andl	$-2, %eax
	leal	(%r9,%r9), %r12d
	leaq	(%rcx,%rcx), %rbx
	movl	%esi, %r11d
	vmovaps	%ymm7, 416(%rsp)
	subl	%eax, %r11d
	vbroadcastss	.LC49(%rip), %ymm7
	vmovaps	%ymm7, 320(%rsp)
	vmovdqa	.LC82(%rip), %ymm7
	vmovdqa	%ymm7, 352(%rsp)
	vbroadcastss	.LC6(%rip), %ymm7
	vmovaps	%ymm7, 384(%rsp)
	vmovss	.LC67(%rip), %xmm7
	vmovss	%xmm7, 316(%rsp)
	vxorps	%xmm7, %xmm7, %xmm7
	jmp	.L276
.L318:
	subl	$2, %esi
.L276:
	movl	%edx, %r10d
	leal	(%r9,%rdx), %eax
	addl	%r12d, %edx
	vshufps	$0, %xmm2, %xmm2, %xmm3
	sarl	$20, %r10d
	sarl	$20, %eax
	vxorps	%xmm5, %xmm5, %xmm5
	vaddss	.LC11(%rip), %xmm2, %xmm13
	vcvtsi2ssl	%r10d, %xmm5, %xmm1
	vaddss	316(%rsp), %xmm2, %xmm2
	vcvtsi2ssl	%eax, %xmm5, %xmm5
	cltq
	vshufps	$0, %xmm13, %xmm13, %xmm13
	vinsertf128	$0x1, %xmm13, %ymm3, %ymm3
	vmulps	256(%rsp), %ymm3, %ymm3
	vshufps	$0, %xmm1, %xmm1, %xmm1
	vshufps	$0, %xmm5, %xmm5, %xmm5
	vinsertf128	$0x1, %xmm5, %ymm1, %ymm1
	vmovaps	160(%rsp), %ymm5
	vaddps	%ymm15, %ymm1, %ymm1
	vsubps	%ymm3, %ymm1, %ymm1
	vandps	416(%rsp), %ymm1, %ymm1
	vsubps	%ymm1, %ymm12, %ymm3
	vsubps	%ymm1, %ymm10, %ymm13
	vminps	192(%rsp), %ymm3, %ymm3
	vsubps	%ymm1, %ymm5, %ymm5
	vsubps	%ymm1, %ymm11, %ymm1
	vmaxps	%ymm7, %ymm13, %ymm13
	vmaxps	%ymm7, %ymm3, %ymm3
	vmaxps	%ymm7, %ymm5, %ymm5
	vmaxps	%ymm7, %ymm1, %ymm1
	vmulps	320(%rsp), %ymm1, %ymm1
	vmulps	%ymm13, %ymm13, %ymm13
	vmulps	%ymm3, %ymm3, %ymm3
	vsubps	%ymm13, %ymm3, %ymm3
	vmulps	%ymm5, %ymm5, %ymm5
	vsubps	%ymm5, %ymm3, %ymm3
	vmovd	%edi, %xmm5
	leaq	(%rcx,%rax,4), %rdi
	movslq	%r10d, %rax
	vmulps	224(%rsp), %ymm3, %ymm3
	vpbroadcastd	%xmm5, %ymm5
	vpcmpgtd	352(%rsp), %ymm5, %ymm5
	vaddps	%ymm3, %ymm1, %ymm1
	vaddps	384(%rsp), %ymm1, %ymm1
	vcvttps2dq	%ymm1, %ymm1
	vpand	%ymm1, %ymm5, %ymm5
	vmovdqu	(%r8,%rdi), %xmm1
	vpslld	$16, %ymm5, %ymm3
	vpor	%ymm5, %ymm3, %ymm3
	vmovdqu	(%r8,%rax,4), %xmm5
	vpsubw	%ymm3, %ymm4, %ymm14
	vinserti128	$1, %xmm1, %ymm5, %ymm5
	vpmullw	%ymm3, %ymm6, %ymm1
	vpsrlw	$8, %ymm5, %ymm13
	vpmullw	%ymm3, %ymm0, %ymm3
	vpand	%ymm5, %ymm4, %ymm5
	vpmullw	%ymm14, %ymm13, %ymm13
	vpmullw	%ymm14, %ymm5, %ymm5
	vpaddw	%ymm8, %ymm1, %ymm1
	vpaddw	%ymm8, %ymm3, %ymm3
	vpaddw	%ymm13, %ymm1, %ymm1
	vpaddw	%ymm5, %ymm3, %ymm3
	vpmulhuw	%ymm9, %ymm1, %ymm1
	vpmulhuw	%ymm9, %ymm3, %ymm3
	vpsllw	$8, %ymm1, %ymm1
	vpor	%ymm3, %ymm1, %ymm1
	vmovdqu	%xmm1, (%r8,%rax,4)
	vperm2i128	$17, %ymm1, %ymm1, %ymm1
	vmovdqu	%xmm1, (%r8,%rdi)
	movl	%esi, %edi
	addq	%rbx, %r8
	cmpl	%r11d, %esi
	jne	.L318
	jmp	.L311
.L270:
	cmpl	%r10d, 416(%rsp)
	jle	.L311
	movl	384(%rsp), %ebx
	cmpl	%ebx, 224(%rsp)
	jle	.L311
	leaq	576(%rsp), %rdx
	leaq	448(%rsp), %rdi
	movq	%r8, %rsi
	cmpl	%r15d, 312(%rsp)
	jg	.L284
	vzeroupper
	call	_ZN3irg6detail19v0_avx2_fma_release14aa_write_steepINS1_17aa_slender_writerINS_10image_viewINS_5rgba8EEEEEEEvRKNS1_10aa_slenderINT_4fourEEERKNS_11cell_windowERS9_
	jmp	.L312
.L315:
	vmovss	.LC69(%rip), %xmm2
	vcomiss	%xmm9, %xmm2
	jb	.L265
	vcomiss	292(%rsp), %xmm15
	movl	%edi, %r9d
	notl	%r9d
	setnb	%r14b
	shrl	$31, %r9d
	andl	%r9d, %r14d
	movb	%r14b, 307(%rsp)
	jmp	.L265
.L271:
	movslq	%esi, %rsi
	testq	%rax, %rax
	je	.L319
	imulq	%rcx, %rsi
	movl	$255, %eax
	movslq	%r12d, %r12
	movslq	%ebx, %rbx
	vmovd	%eax, %xmm8
	vpextrd	$1, %xmm4, %eax
	vpbroadcastq	%xmm1, %ymm10
	vmovdqa	.LC12(%rip), %ymm12
	cltq
	vpbroadcastw	%xmm8, %ymm8
	imulq	%rcx, %rax
	leaq	(%rsi,%r12,4), %r10
	vmovd	%xmm4, %esi
	vmovdqa	%ymm12, 416(%rsp)
	movslq	%esi, %rsi
	leaq	(%rcx,%rcx), %r12
	vpshufb	%ymm12, %ymm10, %ymm10
	addq	%r14, %r10
	imulq	%rcx, %rsi
	leaq	(%r12,%rcx), %r8
	vpand	%ymm8, %ymm10, %ymm10
	leaq	(%rax,%rbx,4), %rax
	addq	%r14, %rax
	leaq	(%r14,%rsi), %r13
.L278:
	vmovd	%xmm3, %esi
	leaq	(%rax,%r12), %rbx
	vpsrldq	$8, %xmm1, %xmm1
	movslq	%r11d, %r11
	movslq	%esi, %rsi
	vmovd	(%rbx), %xmm14
	movl	$255, %r14d
	vpinsrd	$1, (%rax,%r8), %xmm14, %xmm11
	leaq	0(%r13,%rsi,4), %rsi
	vpbroadcastq	%xmm1, %ymm1
	vpshufb	416(%rsp), %ymm1, %ymm1
	leaq	(%rsi,%r12), %r13
	vmovd	0(%r13), %xmm12
	vpinsrd	$1, (%rsi,%r8), %xmm12, %xmm9
	vmovd	(%rsi), %xmm12
	vpinsrd	$1, (%rsi,%rcx), %xmm12, %xmm8
	vmovd	(%rax), %xmm12
	vpunpcklqdq	%xmm9, %xmm8, %xmm8
	vpinsrd	$1, (%rax,%rcx), %xmm12, %xmm9
	vmovdqa	%xmm8, %xmm8
	vpunpcklqdq	%xmm11, %xmm9, %xmm9
	vmovd	%r14d, %xmm11
	movl	$128, %r14d
	vmovdqa	%xmm9, %xmm9
	vpbroadcastw	%xmm11, %ymm11
	vmovd	%r14d, %xmm13
	movl	$257, %r14d
	vinserti128	$1, %xmm9, %ymm8, %ymm8
	vpsubw	%ymm10, %ymm11, %ymm14
	vpbroadcastw	%xmm13, %ymm13
	vpmullw	%ymm10, %ymm6, %ymm9
	vpsrlw	$8, %ymm8, %ymm12
	vpand	%ymm8, %ymm11, %ymm8
	vpmullw	%ymm14, %ymm12, %ymm12
	vpmullw	%ymm10, %ymm0, %ymm10
	vpand	%ymm11, %ymm1, %ymm1
	vpmullw	%ymm14, %ymm8, %ymm8
	vpaddw	%ymm13, %ymm9, %ymm9
	vpaddw	%ymm9, %ymm12, %ymm9
	vmovd	%r14d, %xmm12
	vpaddw	%ymm13, %ymm10, %ymm10
	vpbroadcastw	%xmm12, %ymm12
	vpaddw	%ymm10, %ymm8, %ymm8
	vpmulhuw	%ymm12, %ymm9, %ymm9
	vpmulhuw	%ymm12, %ymm8, %ymm8
	vpsllw	$8, %ymm9, %ymm9
	vpor	%ymm8, %ymm9, %ymm8
	vmovd	%xmm8, (%rsi)
	vpextrd	$1, %xmm8, (%rsi,%rcx)
	vpextrd	$2, %xmm8, 0(%r13)
	vpextrd	$3, %xmm8, (%rsi,%r8)
	vextracti128	$0x1, %ymm8, %xmm8
	vpextrd	$2, %xmm4, %r13d
	vmovd	%xmm8, (%rax)
	vpextrd	$1, %xmm8, (%rax,%rcx)
	movslq	%r13d, %r13
	vpextrd	$2, %xmm8, (%rbx)
	vpextrd	$3, %xmm8, (%rax,%r8)
	movq	160(%rsp), %rax
	movq	16(%rax), %rsi
	movq	(%rax), %rbx
	vpextrd	$3, %xmm4, %eax
	cltq
	testb	$3, %sil
	je	.L320
	imulq	%rsi, %rax
	imulq	%r13, %rsi
	leaq	(%rax,%r11,4), %r11
	addq	%rbx, %r11
	addq	%rsi, %rbx
.L280:
	vpextrd	$2, %xmm3, %eax
	leaq	(%r11,%r12), %rsi
	movl	$255, %r13d
	cltq
	vpmullw	%ymm1, %ymm6, %ymm8
	vmovaps	%xmm15, %xmm15
	leaq	(%rbx,%rax,4), %rax
	vperm2f128	$0, %ymm15, %ymm15, %ymm15
	leaq	(%rax,%r12), %rbx
	vmovd	(%rbx), %xmm4
	vpinsrd	$1, (%rax,%r8), %xmm4, %xmm3
	vmovd	(%rax), %xmm4
	vpinsrd	$1, (%rax,%rcx), %xmm4, %xmm10
	vmovd	(%rsi), %xmm4
	vpinsrd	$1, (%r11,%r8), %xmm4, %xmm4
	vpunpcklqdq	%xmm3, %xmm10, %xmm10
	vmovd	(%r11), %xmm3
	vpinsrd	$1, (%r11,%rcx), %xmm3, %xmm3
	vmovdqa	%xmm10, %xmm10
	vpunpcklqdq	%xmm4, %xmm3, %xmm3
	vmovdqa	%xmm3, %xmm3
	vinserti128	$1, %xmm3, %ymm10, %ymm10
	vmovd	%r13d, %xmm3
	movl	$128, %r13d
	vpbroadcastw	%xmm3, %ymm3
	vpsrlw	$8, %ymm10, %ymm9
	vmovd	%r13d, %xmm4
	movl	$257, %r13d
	vpsubw	%ymm1, %ymm3, %ymm11
	vpand	%ymm10, %ymm3, %ymm10
	vpbroadcastw	%xmm4, %ymm4
	vpmullw	%ymm11, %ymm9, %ymm9
	vpmullw	%ymm1, %ymm0, %ymm1
	vpaddw	%ymm4, %ymm8, %ymm8
	vpmullw	%ymm11, %ymm10, %ymm10
	vpaddw	%ymm9, %ymm8, %ymm9
	vmovd	%r13d, %xmm8
	vpaddw	%ymm4, %ymm1, %ymm1
	vpbroadcastw	%xmm8, %ymm8
	vpaddw	%ymm10, %ymm1, %ymm1
	vpmulhuw	%ymm8, %ymm9, %ymm9
	vpmulhuw	%ymm8, %ymm1, %ymm10
	vpsllw	$8, %ymm9, %ymm1
	vpor	%ymm10, %ymm1, %ymm1
	vmovss	308(%rsp), %xmm10
	vmovd	%xmm1, (%rax)
	vpextrd	$1, %xmm1, (%rax,%rcx)
	vpextrd	$2, %xmm1, (%rbx)
	vpextrd	$3, %xmm1, (%rax,%r8)
	vextracti128	$0x1, %ymm1, %xmm1
	vmovd	%xmm1, (%r11)
	vpextrd	$1, %xmm1, (%r11,%rcx)
	vpextrd	$2, %xmm1, (%rsi)
	vpextrd	$3, %xmm1, (%r11,%r8)
	vmovss	300(%rsp), %xmm1
	vaddss	%xmm1, %xmm7, %xmm7
	vmulss	.LC6(%rip), %xmm7, %xmm7
	vsubss	.LC11(%rip), %xmm7, %xmm14
	vbroadcastss	%xmm14, %ymm14
	vsubss	%xmm10, %xmm7, %xmm13
	vbroadcastss	%xmm7, %ymm12
	vsubss	%xmm1, %xmm7, %xmm7
	vbroadcastss	%xmm7, %ymm7
	vbroadcastss	%xmm13, %ymm13
	vmovaps	%ymm7, 160(%rsp)
	vbroadcastss	%xmm10, %ymm7
	vmovaps	%ymm7, 192(%rsp)
	vbroadcastss	288(%rsp), %ymm7
	vmovaps	%ymm7, 224(%rsp)
	vbroadcastss	%xmm5, %ymm7
	vmovaps	%ymm7, 256(%rsp)
	testl	%edi, %edi
	jle	.L311
	vbroadcastss	.LC4(%rip), %ymm7
	leal	-2(%rdi), %esi
	leal	-1(%rdi), %eax
	vxorps	%xmm9, %xmm9, %xmm9
	andl	$-2, %eax
	movl	%esi, %r13d
	leal	(%r9,%r9), %r14d
	vmovaps	%ymm7, 416(%rsp)
	subl	%eax, %r13d
	vbroadcastss	.LC49(%rip), %ymm7
	vmovaps	%ymm7, 320(%rsp)
	vmovdqa	.LC82(%rip), %ymm7
	vmovdqa	%ymm7, 352(%rsp)
	vbroadcastss	.LC6(%rip), %ymm7
	vmovaps	%ymm7, 384(%rsp)
	vmovss	.LC67(%rip), %xmm7
	vmovss	%xmm7, 316(%rsp)
	jmp	.L282
.L321:
	subl	$2, %esi
.L282:
	movl	%edx, %eax
	leal	(%rdx,%r9), %r11d
	addl	%r14d, %edx
	vshufps	$0, %xmm2, %xmm2, %xmm10
	sarl	$20, %eax
	sarl	$20, %r11d
	vxorps	%xmm7, %xmm7, %xmm7
	vaddss	.LC11(%rip), %xmm2, %xmm5
	vcvtsi2ssl	%eax, %xmm7, %xmm1
	cltq
	vaddss	316(%rsp), %xmm2, %xmm2
	vcvtsi2ssl	%r11d, %xmm7, %xmm7
	movslq	%r11d, %r11
	vshufps	$0, %xmm5, %xmm5, %xmm5
	vinsertf128	$0x1, %xmm5, %ymm10, %ymm5
	imulq	%rcx, %rax
	vmulps	256(%rsp), %ymm5, %ymm5
	imulq	%rcx, %r11
	vshufps	$0, %xmm1, %xmm1, %xmm1
	vshufps	$0, %xmm7, %xmm7, %xmm7
	vinsertf128	$0x1, %xmm7, %ymm1, %ymm1
	addq	%r10, %rax
	vmovaps	160(%rsp), %ymm7
	vaddps	%ymm15, %ymm1, %ymm1
	leaq	(%rax,%r12), %rbx
	vsubps	%ymm5, %ymm1, %ymm1
	vandps	416(%rsp), %ymm1, %ymm1
	vsubps	%ymm1, %ymm12, %ymm5
	vsubps	%ymm1, %ymm14, %ymm10
	vminps	192(%rsp), %ymm5, %ymm5
	vsubps	%ymm1, %ymm7, %ymm7
	vsubps	%ymm1, %ymm13, %ymm1
	vmaxps	%ymm9, %ymm10, %ymm10
	vmaxps	%ymm9, %ymm5, %ymm5
	vmaxps	%ymm9, %ymm7, %ymm7
	vmaxps	%ymm9, %ymm1, %ymm1
	vmulps	320(%rsp), %ymm1, %ymm1
	vmulps	%ymm10, %ymm10, %ymm10
	vmulps	%ymm5, %ymm5, %ymm5
	vsubps	%ymm10, %ymm5, %ymm5
	vmulps	%ymm7, %ymm7, %ymm7
	vsubps	%ymm7, %ymm5, %ymm5
	vmovd	%edi, %xmm7
	leaq	4(%r10,%r11), %rdi
	addq	$8, %r10
	vpbroadcastd	%xmm7, %ymm7
	leaq	(%rdi,%r12), %r11
	vpcmpgtd	352(%rsp), %ymm7, %ymm7
	vmulps	224(%rsp), %ymm5, %ymm5
	vaddps	%ymm5, %ymm1, %ymm1
	vmovd	(%rbx), %xmm5
	vaddps	384(%rsp), %ymm1, %ymm1
	vcvttps2dq	%ymm1, %ymm1
	vpand	%ymm1, %ymm7, %ymm1
	vpslld	$16, %ymm1, %ymm7
	vpor	%ymm1, %ymm7, %ymm7
	vpinsrd	$1, (%rax,%r8), %xmm5, %xmm1
	vmovd	(%rax), %xmm5
	vpinsrd	$1, (%rax,%rcx), %xmm5, %xmm5
	vpsubw	%ymm7, %ymm3, %ymm11
	vpunpcklqdq	%xmm1, %xmm5, %xmm5
	vmovd	(%r11), %xmm1
	vpinsrd	$1, (%rdi,%r8), %xmm1, %xmm10
	vmovd	(%rdi), %xmm1
	vpinsrd	$1, (%rdi,%rcx), %xmm1, %xmm1
	vmovdqa	%xmm5, %xmm5
	vpunpcklqdq	%xmm10, %xmm1, %xmm1
	vmovdqa	%xmm1, %xmm1
	vinserti128	$1, %xmm1, %ymm5, %ymm5
	vpmullw	%ymm7, %ymm6, %ymm1
	vpsrlw	$8, %ymm5, %ymm10
	vpmullw	%ymm7, %ymm0, %ymm7
	vpand	%ymm5, %ymm3, %ymm5
	vpmullw	%ymm11, %ymm10, %ymm10
	vpmullw	%ymm11, %ymm5, %ymm5
	vpaddw	%ymm4, %ymm1, %ymm1
	vpaddw	%ymm4, %ymm7, %ymm7
	vpaddw	%ymm10, %ymm1, %ymm1
	vpaddw	%ymm5, %ymm7, %ymm7
	vpmulhuw	%ymm8, %ymm1, %ymm1
	vpmulhuw	%ymm8, %ymm7, %ymm7
	vpsllw	$8, %ymm1, %ymm1
	vpor	%ymm7, %ymm1, %ymm1
	vmovd	%xmm1, (%rax)
	vpextrd	$1, %xmm1, (%rax,%rcx)
	vpextrd	$2, %xmm1, (%rbx)
	vpextrd	$3, %xmm1, (%rax,%r8)
	vextracti128	$0x1, %ymm1, %xmm1
	vmovd	%xmm1, (%rdi)
	vpextrd	$1, %xmm1, (%rdi,%rcx)
	vpextrd	$2, %xmm1, (%r11)
	vpextrd	$3, %xmm1, (%rdi,%r8)
	movl	%esi, %edi
	cmpl	%r13d, %esi
	jne	.L321
	jmp	.L311
.L284:
	vzeroupper
	call	_ZN3irg6detail19v0_avx2_fma_release13aa_write_flatINS1_17aa_slender_writerINS_10image_viewINS_5rgba8EEEEEEEvRKNS1_10aa_slenderINT_4fourEEERKNS_11cell_windowERS9_
	jmp	.L312
.L320:
	testq	%rsi, %rsi
	leaq	3(%rsi), %r14
	cmovs	%r14, %rsi
	sarq	$2, %rsi
	imulq	%rsi, %rax
	imulq	%r13, %rsi
	addq	%r11, %rax
	leaq	(%rbx,%rax,4), %r11
	leaq	(%rbx,%rsi,4), %rbx
	jmp	.L280
.L319:
	testq	%rcx, %rcx
	leaq	3(%rcx), %rax
	movslq	%r12d, %r12
	movslq	%ebx, %rbx
	cmovns	%rcx, %rax
	vmovdqa	.LC12(%rip), %ymm12
	vpbroadcastq	%xmm1, %ymm10
	sarq	$2, %rax
	vpshufb	%ymm12, %ymm10, %ymm10
	vmovdqa	%ymm12, 416(%rsp)
	imulq	%rax, %rsi
	movq	%rax, %r13
	leaq	(%rsi,%r12), %rax
	vmovd	%xmm4, %esi
	leaq	(%rcx,%rcx), %r12
	leaq	(%r14,%rax,4), %r10
	movl	$255, %eax
	leaq	(%r12,%rcx), %r8
	movslq	%esi, %rsi
	vmovd	%eax, %xmm8
	imulq	%r13, %rsi
	vpextrd	$1, %xmm4, %eax
	cltq
	vpbroadcastw	%xmm8, %ymm8
	imulq	%r13, %rax
	vpand	%ymm8, %ymm10, %ymm10
	leaq	(%r14,%rsi,4), %r13
	addq	%rbx, %rax
	leaq	(%r14,%rax,4), %rax
	jmp	.L278
.L317:
	testq	%rsi, %rsi
	leaq	3(%rsi), %r12
	cmovns	%rsi, %r12
	sarq	$2, %r12
	imulq	%r12, %r11
	imulq	%r10, %r12
	leaq	(%r11,%rbx), %rsi
	leaq	(%rax,%rsi,4), %r11
	leaq	(%rax,%r12,4), %rax
	jmp	.L275
.L316:
	testq	%rcx, %rcx
	leaq	3(%rcx), %rax
	vpextrd	$1, %xmm4, %r10d
	movslq	%esi, %rsi
	cmovns	%rcx, %rax
	movslq	%r10d, %r10
	vpbroadcastq	%xmm1, %ymm10
	vmovdqa	.LC12(%rip), %ymm14
	sarq	$2, %rax
	vpshufb	%ymm14, %ymm10, %ymm10
	vmovdqa	%ymm14, 416(%rsp)
	imulq	%rax, %r12
	addq	%r12, %rsi
	leaq	(%r14,%rsi,4), %r8
	movl	$255, %esi
	vmovd	%esi, %xmm8
	movslq	%ebx, %rsi
	imulq	%rax, %rsi
	vpbroadcastw	%xmm8, %ymm8
	vpand	%ymm8, %ymm10, %ymm10
	addq	%r10, %rsi
	vmovd	%xmm3, %r10d
	movslq	%r10d, %r10
	leaq	(%r14,%rsi,4), %rsi
	imulq	%r10, %rax
	leaq	(%r14,%rax,4), %r10
	jmp	.L273
.LFE3641:
	.section	.text._ZN3irg6detail19v0_avx2_fma_release6aa_boxINS1_16aa_mixing_writerINS_10image_viewINS_5rgba8EEEEEEEvRKNS1_10aa_overlapESA_RKNS_11cell_windowERT_,"axG",@progbits,_ZN3irg6detail19v0_avx2_fma_release6aa_boxINS1_16aa_mixing_writerINS_10image_viewINS_5rgba8EEEEEEEvRKNS1_10aa_overlapESA_RKNS_11cell_windowERT_,comdat
	.weak	_ZN3irg6detail19v0_avx2_fma_release6aa_boxINS1_16aa_mixing_writerINS_10image_viewINS_5rgba8EEEEEEEvRKNS1_10aa_overlapESA_RKNS_11cell_windowERT_
